// Predicts the distances that a time-of-flight sensor measures in a known room, zone by zone. Then
// reports the measured zones that differ from the map.
//
// The map is useless if the sensor is outside it, so each place is first tested to be in the room's
// air. The last place is wrong, as odometry reports it after a wheel has slipped.
//
// Prints for each place the instructions of the whole scan, from floats to millimetres, and each
// zone's distance along its ray; "-" if the ray hits nothing within its reach. Run it by hand with
// FLASHBVH_ICOUNT to see the instruction counts (ports/README.md).
#include <flashbvh/image.hpp>
#include <flashbvh/ray.hpp>
#include <flashbvh/solid.hpp>
#include <flashbvh/units.hpp>

#include "insn.hpp"
#include "measured.hpp"
#include "room.fbvh.h"
#include "sensor.hpp"
#include "text.hpp"

using namespace flashbvh;

namespace {

const Mesh room = view_unchecked<Mesh>(room_image);

constexpr Place kAtTheDoor = {"at the door", {4600, 450, 1300}, {-0.8f, 0.6f, 0}, {0, 0, 1}};
constexpr Place kOverTheTable = {
    "over the table", {2600, 2750, 1500}, {0.8f, 0, -0.6f}, {0.6f, 0, 0.8f}};
constexpr Place kAtTheShelves = {
    "at the shelves", {1500, 1450, 1250}, {-0.96f, 0.28f, 0}, {0, 0, 1}};
constexpr Place kInThePillar = {"in the pillar", {3000, 1500, 1200}, {-1, 0, 0}, {0, 0, 1}};

struct Scan {
  bool is_valid;
  uint16_t mm[kZones];  ///< kNothing where no echo is expected
};

/// After an error a point counts as inside, which here would permit to go on: so test the status.
bool is_in_air(const Point& point) {
  const PointAnswer answer = inside(room, point);
  return answer.status == Status::done && answer.side == PointSide::inside;
}

/// Converts a distance in 1/256 cell, rounded to the nearest.
uint16_t millimetres(uint32_t distance) {
  return static_cast<uint16_t>((millionths_of(distance, room.cell_bits) + 500000) / 1000000);
}

/// Each ray starts with the last hit triangle as a hint. A hint never changes an answer, and saves
/// visits if neighbours mostly hit one triangle of many. With few triangles, as here, it hardly
/// matters (lib/docs/figures.md, Rays).
Scan scan_at(const Place& place) {
  const Sensor sensor(place, room_CELLS_PER_UNIT);
  Scan scan = {};
  uint16_t hint = kNoHint<uint16_t>;
  for (int zone = 0; zone < kZones; ++zone) {
    const MadeSegment ray = sensor.ray(zone);
    // All rays start in the same cell.
    if (ray.status != Status::done || (zone == 0 && !is_in_air(ray.segment.from))) {
      return scan;
    }
    const RayAnswer<uint16_t> answer = nearest_hit(room, ray.segment, hint);
    if (answer.status != Status::done) {
      return scan;
    }
    scan.mm[zone] = kNothing;
    if (answer.yes) {
      scan.mm[zone] = millimetres(distance_along(ray.segment, answer.hit.along));
      hint = answer.hit.slot;
    }
  }
  scan.is_valid = true;
  return scan;
}

/// Prints four columns after a space.
void print_mm(uint16_t mm) {
  if (mm == kNothing) {
    port::print("    -");
    return;
  }
  port::print(mm < 10 ? "    " : mm < 100 ? "   " : mm < 1000 ? "  " : " ", unsigned{mm});
}

Scan print_scan(const Place& place) {
  Scan scan = {};
  const uint32_t instructions = port::instructions_of([&] { scan = scan_at(place); });
  port::print(place.name, ": ");
  if (!scan.is_valid) {
    port::print("not in the room\n");
    return scan;
  }
  port::print(instructions, " instructions\n");
  for (int zone = 0; zone < kZones; ++zone) {
    print_mm(scan.mm[zone]);
    port::print(zone % kSide == kSide - 1 ? "\n" : "");
  }
  return scan;
}

/// Allows a sixteenth and two centimetres, for the sensor's noise and the place's error.
bool agree(uint16_t measured, uint16_t expected) {
  const int difference = measured < expected ? expected - measured : measured - expected;
  return difference <= expected / 16 + 20;
}

/// Prints the zones whose measurement differs from the map; returns their number.
int print_differences(const Scan& scan, const uint16_t (&measured)[kZones]) {
  int count = 0;
  for (int zone = 0; zone < kZones; ++zone) {
    if (!agree(measured[zone], scan.mm[zone])) {
      port::print("row ", zone / kSide, ", column ", zone % kSide, ": measured ",
                  unsigned{measured[zone]}, " mm, the map has ", unsigned{scan.mm[zone]}, " mm\n");
      ++count;
    }
  }
  return count;
}

}  // namespace

int main() {
  const bool scanned = print_scan(kAtTheDoor).is_valid && print_scan(kOverTheTable).is_valid;
  const Scan shelves = print_scan(kAtTheShelves);
  const int differences = print_differences(shelves, kMeasuredAtTheShelves);
  const Scan wrong = print_scan(kInThePillar);
  return scanned && shelves.is_valid && differences == 1 && !wrong.is_valid ? 0 : 1;
}
