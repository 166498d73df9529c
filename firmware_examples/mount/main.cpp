// A telescope's mount slews to a star: would the tube, its camera or the weights touch the tripod?
// The mount certifies each slew for every moment, before it begins.
//
// The example shows a chain of two joints as a body's motion. Both angles decide whether the tube
// touches, so limits of single axes would not suffice. If both axes cannot move at once, the mount
// tries one after the other. Then it tries to reach the star from the other side of the meridian.
//
// Prints the attempts for each slew and where a body would touch, in degrees of the hour axis and
// the declination axis; then the cost of the checks. Run it by hand with FLASHBVH_ICOUNT to see the
// instruction counts (ports/README.md). Exits with 1 if the checks cost too much.
#include "insn.hpp"
#include "slew.hpp"
#include "stack.hpp"
#include "text.hpp"

using namespace flashbvh;

namespace {

/// The work of a slice, in units of query.hpp.
constexpr uint32_t kWork = 500;
/// Bodies nearer than this count as touching: the tube bends, and cables hang from it.
constexpr uint32_t kMargin = static_cast<uint32_t>(20 * 256 / tripod_CELL) + 1;  // 20 mm

/// Limits that the tests hold, at 168 MHz and one instruction per cycle: 1 ms for a slice, 1.5 s
/// for a slew with all attempts; and bytes of RAM for the whole firmware.
constexpr uint32_t kMostOfSlice = 168'000;
constexpr uint32_t kMostOfSlew = 252'000'000;
constexpr uint32_t kMostBytes = 4096;

/// Instructions, 0 on the host.
uint32_t of_slew = 0;
uint32_t most_of_slew = 0;
uint32_t most_of_slice = 0;

/// Between slices a mount goes on following a star. The example counts these turns.
uint32_t tracked = 0;
void track() {
  ++tracked;
}

/// Prints degrees with one decimal, rounded to the nearest.
void print_degrees(int32_t turn) {
  const auto size = static_cast<uint32_t>(turn < 0 ? -turn : turn);
  const auto tenths = static_cast<uint32_t>((uint64_t{size} * 3600 + kHalfTurn) / kFullTurn);
  port::print(turn < 0 ? "-" : "", tenths / 10, ".", tenths % 10);
}
void print_angles(const Angles& angles) {
  print_degrees(angles.hour);
  port::print(", ");
  print_degrees(angles.declination);
}

/// True if nothing touches; else prints the body and the angles. An error is no permission to move.
bool certify(const Slew& slew) {
  for (const Body& body : kBodies) {
    const BodyMotion motion = slew.motion(body.axes);
    FirstContact query(tripod, body.mesh, motion, {kMargin});
    FirstContactAnswer answer{};
    do {
      const uint32_t slice = port::instructions_of([&] { answer = query.run(kWork); });
      of_slew += slice;
      most_of_slice = slice > most_of_slice ? slice : most_of_slice;
      track();
    } while (answer.status == Status::suspended);
    if (answer.status != Status::done || answer.outcome != ContactOutcome::free) {
      port::print(body.name, answer.status == Status::done ? " touches at " : " fails at ");
      print_angles(slew.at(answer.from));
      port::print("\n");
      return false;
    }
  }
  return true;
}

/// Tries the route through `via`. There one axis, or none, has already arrived.
bool try_route(const char* name, const Angles& from, const Angles& via, const Angles& to) {
  port::print("  ", name, ": ");
  const bool is_free = certify(Slew(from, via)) && certify(Slew(via, to));
  port::print(is_free ? "free\n" : "");
  return is_free;
}

bool try_orders(const Angles& from, const Angles& to) {
  return try_route("both axes at once", from, from, to) ||
         try_route("hour axis first", from, {to.hour, from.declination}, to) ||
         try_route("declination axis first", from, {from.hour, to.declination}, to);
}

/// The other angles that point the tube at the same star: half a turn about the polar axis.
Angles beyond_meridian(const Angles& angles) {
  return {angles.hour + (angles.hour > 0 ? -kHalfTurn : kHalfTurn), -angles.declination};
}

/// Returns the angles at which the mount stands after the slew.
Angles slew(const Angles& from, const Angles& to) {
  port::print("slew to ");
  print_angles(to);
  port::print(":\n");
  if (try_orders(from, to)) {
    return to;
  }
  const Angles beyond = beyond_meridian(to);
  port::print(" through the meridian, to ");
  print_angles(beyond);
  port::print(":\n");
  if (try_orders(from, beyond)) {
    return beyond;
  }
  port::print("  refused\n");
  return from;
}

}  // namespace

int main() {
  constexpr Angles kStars[] = {degrees(60, 10), degrees(90, 60), degrees(85, 0), degrees(90, 30),
                               degrees(0, 0)};
  Angles at = degrees(0, 0);
  for (const Angles& star : kStars) {
    of_slew = 0;
    at = slew(at, star);
    most_of_slew = of_slew > most_of_slew ? of_slew : most_of_slew;
  }
  const uint32_t bytes = port::static_bytes() + port::stack_used();
  port::print("tracked between ", tracked, " slices; instructions of a slice: ", most_of_slice,
              " at most, of a slew ", most_of_slew, "\nRAM: ", bytes, " bytes\n");
  return most_of_slice <= kMostOfSlice && most_of_slew <= kMostOfSlew && bytes <= kMostBytes ? 0
                                                                                             : 1;
}
