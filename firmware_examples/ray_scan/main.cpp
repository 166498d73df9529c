// Predicts the distances that a time-of-flight sensor of 8 x 8 zones measures in a known room, then
// reports the measured zones that differ from the map.
//
// The map is useless if the sensor is outside it, so each place is first tested to be in the room's
// air. The last place is wrong, as odometry reports it after a wheel has slipped.
//
// Prints for each place the instructions of the whole scan, from floats to millimetres, and each
// zone's distance along its ray; "-" if the ray hits nothing within its reach. Run it by hand with
// FLASHBVH_ICOUNT to see the instruction counts (ports/README.md).
#include <flashbvh/float.hpp>
#include <flashbvh/image.hpp>
#include <flashbvh/ray.hpp>
#include <flashbvh/solid.hpp>
#include <flashbvh/units.hpp>

#include "insn.hpp"
#include "room.fbvh.h"
#include "text.hpp"

using namespace flashbvh;

namespace {

const Mesh room = view_unchecked<Mesh>(room_image);

constexpr int kSide = 8;
constexpr int kZones = kSide * kSide;
/// The sensor's reach, in millimetres.
constexpr float kReach = 4000;
/// The distance of a zone without an echo within the reach, in millimetres.
constexpr uint16_t kNothing = 0;

/// A sensor's position in millimetres and its orientation, in the room's frame: perpendicular
/// vectors of length 1.
struct Place {
  const char* name;
  float at[3];
  float forward[3];
  float right[3];
  float up[3];
};
constexpr Place kOverTheTable = {
    "over the table", {2600, 2750, 1500}, {0.8f, 0, -0.6f}, {0, -1, 0}, {0.6f, 0, 0.8f}};
constexpr Place kAtTheShelves = {
    "at the shelves", {1500, 1450, 1250}, {-0.96f, 0.28f, 0}, {0.28f, 0.96f, 0}, {0, 0, 1}};
constexpr Place kInThePillar = {
    "in the pillar", {3000, 1500, 1200}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// The sensor's readings at the shelves, in millimetres from the upper left zone. They are
/// invented: the map's distances with 1.2 % of noise, and a carton that is not on the map.
constexpr uint16_t kMeasuredAtTheShelves[kZones] = {
    1583, 1600, 1603, 1633, 1670, 1754, 1532, 1973,  //
    1566, 1552, 1568, 1596, 1608, 1728, 1480, 1924,  //
    1356, 1317, 1304, 1298, 1310, 1318, 1362, 1864,  //
    1511, 1510, 1503, 1575, 1602, 1682, 1418, 1844,  //
    1499, 1501, 1243, 1548, 1582, 1639, 1420, 1888,  //
    1504, 1522, 1524, 1473, 1501, 1540, 1408, 1871,  //
    1545, 1532, 1570, 1591, 1612, 1727, 1483, 1935,  //
    1615, 1597, 1609, 1613, 1701, 1746, 1504, 1933,  //
};

/// The ray through the centre of a zone. Zones are numbered row by row from the upper left corner,
/// as the sensor sees it.
MadeSegment ray_of(const Place& place, int zone) {
  constexpr float kMiddle = (kSide - 1) / 2.0f;
  // A zone's width at distance 1: 0.41421356 is the tangent of 45 / 2 degrees.
  constexpr float kZone = 2 * 0.41421356f / kSide;
  const float right = kZone * (static_cast<float>(zone % kSide) - kMiddle);
  const float up = kZone * (kMiddle - static_cast<float>(zone / kSide));
  float direction[3];
  for (int i = 0; i < 3; ++i) {
    direction[i] = place.forward[i] + right * place.right[i] + up * place.up[i];
  }
  return segment_of(place.at, direction, kReach, room_CELLS_PER_UNIT);
}

struct Scan {
  bool is_valid;
  uint16_t mm[kZones];  ///< kNothing where no echo is expected
};

/// After an error a point counts as inside, which here would permit to go on: so test the status.
bool is_in_air(const Point& point) {
  const PointAnswer answer = inside(room, point);
  return answer.status == Status::done && answer.side == PointSide::inside;
}

/// Each ray starts with the last hit triangle as a hint. A hint never changes an answer, and saves
/// visits if neighbours mostly hit one triangle of many.
Scan scan_at(const Place& place) {
  Scan scan = {};
  uint16_t hint = kNoHint<uint16_t>;
  for (int zone = 0; zone < kZones; ++zone) {
    const MadeSegment ray = ray_of(place, zone);
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
      const uint32_t distance = distance_along(ray.segment, answer.hit.along);
      scan.mm[zone] =
          static_cast<uint16_t>((millionths_of(distance, room.cell_bits) + 500000) / 1000000);
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

/// Prints the zones whose measurement differs from the map, by more than a sixteenth and two
/// centimetres, for the sensor's noise and the place's error. Returns their number.
int print_differences(const Scan& scan, const uint16_t (&measured)[kZones]) {
  int count = 0;
  for (int zone = 0; zone < kZones; ++zone) {
    const int expected = scan.mm[zone];
    const int difference = measured[zone] - expected;
    if ((difference < 0 ? -difference : difference) > expected / 16 + 20) {
      port::print("row ", zone / kSide, ", column ", zone % kSide, ": measured ",
                  unsigned{measured[zone]}, " mm, the map has ", expected, " mm\n");
      ++count;
    }
  }
  return count;
}

}  // namespace

int main() {
  const bool scanned = print_scan(kOverTheTable).is_valid;
  const Scan shelves = print_scan(kAtTheShelves);
  const int differences = print_differences(shelves, kMeasuredAtTheShelves);
  const Scan wrong = print_scan(kInThePillar);
  return scanned && shelves.is_valid && differences == 1 && !wrong.is_valid ? 0 : 1;
}
