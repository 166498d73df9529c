// Motions of the KR5's links through the poses of kr5.cpp in which they are near: 100 cells each, B
// straight, and turning. In multiples of the distance in their middle, with the nearest pair 10
// cells before as a hint.
#include "flashbvh/clearance.hpp"
#include "flashbvh/first_contact.hpp"

#include "asked.hpp"
#include "report.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr int32_t kWay = 100;  // cells
constexpr int32_t kStep = 10;

Pose moved(const Asked& asked, int32_t by) {
  Asked at = asked;
  at.cells[0] += by;
  return pose_of(at);
}

/// Half the diagonal of a box, in cells, rounded up.
int32_t radius_of(const Mesh& mesh) {
  const Box box = unpack(mesh.nodes[0].box);
  const int64_t x = box.upper.x - box.lower.x;
  const int64_t y = box.upper.y - box.lower.y;
  const int64_t z = box.upper.z - box.lower.z;
  return static_cast<int32_t>(detail::square_root(static_cast<uint64_t>(x * x + y * y + z * z)) / 2);
}

uint32_t certify(const Mesh& a, const Mesh& b, const BodyMotion& motion, const Name& name) {
  FirstContactAnswer answer{};
  const uint32_t instructions = measure(name, [&] {
    FirstContact query(a, b, motion);
    answer = query.run(UINT32_MAX);
  });
  add_to_digest(static_cast<uint32_t>(answer.outcome));
  add_to_digest(answer.from);
  add_to_digest(answer.to);
  return instructions;
}

bool ask(const AskedPair& pair, const Asked& asked, const char* motion, const char* proximity) {
  if (proximity == kProximityNames[0]) {
    return true;
  }
  const Pose pose = pose_of(asked);
  const Clearance<uint16_t> near = distance(*pair.a, *pair.b, moved(asked, -kStep));
  const uint32_t seeded = measure({{"motion", motion, proximity, "distance"}}, [&] {
    (void)distance(*pair.a, *pair.b, pose, near.witness);
  });
  const Pose from = moved(asked, -kWay / 2);
  const Pose to = moved(asked, kWay / 2);
  const uint32_t straight = certify(*pair.a, *pair.b, BodyMotion::between(from, to),
                                    {{"motion", motion, proximity, "straight"}});
  add_quotient({{"motion", motion, proximity, "of_distance"}}, straight, seeded);
  // About an axis through the origin of B's frame, by a turn that moves its farthest points so far.
  const int32_t turn = static_cast<int32_t>(int64_t{kFullTurn} * kWay / 6 / radius_of(*pair.b));
  const Move move = {{0, 0, 0}, {0, kRotationOne, 0}, turn, {0, 0, 0}};
  (void)certify(*pair.a, *pair.b, BodyMotion(pose, &move, 1),
                {{"motion", motion, proximity, "turning"}});
  return true;
}

}  // namespace
}  // namespace figures

int main() {
  return figures::print_all("motion", figures::ask_all(figures::ask));
}
