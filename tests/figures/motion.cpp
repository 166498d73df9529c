// Motions of the KR5's links through the near poses of kr5.cpp: 100 cells each, B straight,
// turning.
#include "flashbvh/clearance.hpp"
#include "flashbvh/first_contact.hpp"

#include "query_pose.hpp"
#include "report.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr int32_t kWay = 100;  // cells

/// A turn about an axis through the middle of B's box that moves its corners by kWay.
Move turn_of(const Mesh& b, const Pose& pose) {
  const Box box = unpack(b.nodes[0].box);
  const int32_t lower[3] = {box.lower.x, box.lower.y, box.lower.z};
  const int32_t upper[3] = {box.upper.x, box.upper.y, box.upper.z};
  int64_t squared = 0;
  int64_t middle[3];
  for (int i = 0; i < 3; ++i) {
    squared += int64_t{upper[i] - lower[i]} * (upper[i] - lower[i]);
    middle[i] = b.origin[i] + (lower[i] + upper[i]) / 2;
  }
  const auto radius = static_cast<int32_t>(detail::square_root(static_cast<uint64_t>(squared)) / 2);
  Move move = {{0, 0, 0}, {0, kRotationOne, 0}, 0, {0, 0, 0}};
  move.turn = static_cast<int32_t>(int64_t{kFullTurn} * kWay / 6 / radius);
  for (int i = 0; i < 3; ++i) {
    const int64_t turned = pose.rotation(i, 0) * middle[0] + pose.rotation(i, 1) * middle[1] +
                           pose.rotation(i, 2) * middle[2];
    move.point[i] = static_cast<int32_t>((pose.translation(i) + (turned >> 30)) * kFrameCell);
  }
  return move;
}

/// Certifies a motion, and measures the distance in its middle, with the nearest pair of a tenth of
/// the motion before as hint.
void certify(const MeshPair& pair, const BodyMotion& motion, const char* pose_kind,
             const char* proximity, const char* kind) {
  const Pose before = motion.pose_at(kMotionEnd / 10 * 4);
  const Pose middle = motion.pose_at(kMotionEnd / 2);
  const Clearance<uint16_t> near = distance(*pair.a, *pair.b, before);
  const uint32_t seeded =
      port::instructions_of([&] { (void)distance(*pair.a, *pair.b, middle, near.witness); });
  FirstContactAnswer answer{};
  const uint32_t instructions = measure({{"motion", pose_kind, proximity, kind}}, [&] {
    FirstContact query(*pair.a, *pair.b, motion);
    answer = query.run(UINT32_MAX);
  });
  add_quotient({{"motion", pose_kind, proximity, kind, "of_distance"}}, instructions, seeded);
  add_to_digest(static_cast<uint32_t>(answer.outcome));
  add_to_digest(answer.from);
  add_to_digest(answer.to);
}

bool measure_pose(const MeshPair& pair, const QueryPose& query_pose, const char* motion,
                  const char* proximity) {
  if (proximity == kProximityNames[0]) {
    return true;
  }
  const Pose from = pose_of(query_pose, -kWay / 2);
  const Pose to = pose_of(query_pose, kWay / 2);
  BodyMotion straight = BodyMotion::between(from, to);
  measure({{"motion", "between", motion}}, [&] { straight = BodyMotion::between(from, to); });
  measure({{"motion", "pose_at", motion}}, [&] { (void)straight.pose_at(kMotionEnd / 4); });
  certify(pair, straight, motion, proximity, "straight");
  const Pose pose = pose_of(query_pose);
  const Move move = turn_of(*pair.b, pose);
  certify(pair, BodyMotion(pose, &move, 1), motion, proximity, "turning");
  return true;
}

}  // namespace
}  // namespace figures

int main() {
  return figures::print_all("motion", figures::for_each_query_pose(figures::measure_pose));
}
