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
  const MeshBox box(b);
  const Point middle = box.middle();
  const int64_t x = box.upper.x - box.lower.x;
  const int64_t y = box.upper.y - box.lower.y;
  const int64_t z = box.upper.z - box.lower.z;
  const auto squared = static_cast<uint64_t>(x * x + y * y + z * z);
  const auto radius = static_cast<int32_t>(detail::square_root(squared) / 2);
  Move move = {{0, 0, 0}, {0, kRotationOne, 0}, 0, {0, 0, 0}};
  move.turn = static_cast<int32_t>(int64_t{kFullTurn} * kWay / 6 / radius);
  for (int i = 0; i < 3; ++i) {
    const int64_t turned = pose.rotation(i, 0) * middle.x + pose.rotation(i, 1) * middle.y +
                           pose.rotation(i, 2) * middle.z;
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
