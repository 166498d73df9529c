// First contacts of links: motions of 100 cells through their close poses, straight and turning.
#include "costs.hpp"
#include "flashbvh/first_contact.hpp"
#include "links.hpp"

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

void certify(const LinkPair& pair, const BodyMotion& motion, const PoseKey& key, const char* kind) {
  FirstContactAnswer answer{};
  measure({{"motion", key.motion(), key.proximity_name(), kind}}, [&] {
    FirstContact query(*pair.a, *pair.b, motion);
    answer = query.run(UINT32_MAX);
  });
  add_to_digest(static_cast<uint32_t>(answer.outcome));
  add_to_digest(answer.from);
  add_to_digest(answer.to);
}

}  // namespace

bool measure_motions() {
  return for_each_pose([](const LinkPair& pair, const PoseKey& key) {
    if (key.proximity == Proximity::close) {
      certify(pair, BodyMotion::between(key.pose(-kWay / 2), key.pose(kWay / 2)), key, "straight");
      const Pose pose = key.pose();
      const Move move = turn_of(*pair.b, pose);
      certify(pair, BodyMotion(pose, &move, 1), key, "turning");
    }
    return true;
  });
}

}  // namespace figures
