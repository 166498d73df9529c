// A telescope's mount slews to a star: would the tube, its camera or the weights touch the tripod?
// Each slew is certified for every moment of it, before it begins.
//
// It shows a chain of two joints as a body's motion. Where the tube touches depends on both angles,
// so no limits of single axes would do. If both axes at once do not get through, the mount tries
// one after the other, and then the star from the other side of the meridian.
//
// Prints for each slew, in degrees of the hour axis and the declination axis, what was tried and
// where a body would touch; then what the checks took. Instructions are counted, so run it by hand
// with FLASHBVH_ICOUNT (ports/README.md). Ends with 1 if the checks took too much.
#include "insn.hpp"
#include "slew.hpp"
#include "stack.hpp"
#include "text.hpp"

using namespace flashbvh;

namespace {

/// Of a slice, in units of query.hpp.
constexpr uint32_t kWork = 500;
/// Bodies that come so near touch: for a tube that bends, and cables.
constexpr uint32_t kMargin = static_cast<uint32_t>(20 * 256 / tripod_CELL);  // 20 mm

/// What the tests hold at 168 MHz, an instruction a cycle: 1 ms for a slice, 1.5 s for a slew
/// with all that is tried; and bytes of RAM, for the whole firmware.
constexpr uint32_t kMostOfSlice = 168'000;
constexpr uint32_t kMostOfSlew = 252'000'000;
constexpr uint32_t kMostBytes = 4096;

/// Instructions, 0 on the host.
uint32_t of_slew = 0;
uint32_t most_of_slew = 0;
uint32_t most_of_slice = 0;

/// Between slices the mount goes on following a star; here that is counted.
uint32_t tracked = 0;
void track() {
  ++tracked;
}

/// Angles in degrees, one decimal, to the nearest.
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

/// Whether nothing touches; prints what would, and where. An error is no permission to move.
bool certify(const Slew& slew) {
  for (const Body& body : kBodies) {
    const BodyMotion motion = slew.motion(body.axes);
    FirstContact query(tripod, body.mesh, motion, kMargin);
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

/// Through `via`, where one axis has arrived, or none.
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

/// The tube points there, too, half a turn round the pole.
Angles beyond_meridian(const Angles& angles) {
  return {angles.hour + (angles.hour > 0 ? -kHalfTurn : kHalfTurn), -angles.declination};
}

/// Where the mount then stands.
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
