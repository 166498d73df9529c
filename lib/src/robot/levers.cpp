#include "levers.hpp"

#include "spheres.hpp"

namespace flashbvh::detail {
namespace {

/// Largest error of a frame over the whole range, in 1/2,048 cell.
constexpr uint32_t kFrameError = 32;

/// Beyond this sum of turns levers gain nothing; in units of a joint's coordinate.
constexpr uint64_t kMostTurned = 1u << 24;

/// Largest distance of a point of the link's sphere from the joint's axis, in 1/2,048 cell.
uint64_t lever_at(const Frame& frame, const RobotLink& link, const Frame& frame_of_link) {
  int64_t from_origin[3];
  for (int i = 0; i < 3; ++i) {
    from_origin[i] = centre_of(link, frame_of_link, i) - frame.translation[i];
  }
  uint64_t squared = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    const int k = i == 0 ? 2 : i - 1;
    const int64_t across =
        (frame.rotation[j][2] * from_origin[k] - frame.rotation[k][2] * from_origin[j]) >> 30;
    squared += static_cast<uint64_t>(across * across);
  }
  return uint64_t{square_root(squared)} + kFrameError + link.radius;
}

/// The lever of a link about a joint at their current frames, as a share of the joint's reach.
uint8_t share_of(const RobotJoint& joint, const Frame& frame, const RobotLink& link,
                 const Frame& frame_of_link, uint32_t reach) {
  const uint32_t part = reach >> 8;
  if (part == 0 || joint.type == JointType::prismatic || joint.type == JointType::fixed) {
    return kWholeReach;
  }
  const uint32_t share = reach_at(lever_at(frame, link, frame_of_link)) / part;
  return share < kWholeReach ? static_cast<uint8_t>(share) : kWholeReach;
}

}  // namespace

void set_shares(const Robot& robot, const RobotPair& pair, const Frame* frames, uint8_t* shares) {
  const RobotLink& a = robot.links[pair.a];
  const RobotLink& b = robot.links[pair.b];
  uint32_t passed = 0;
  uint32_t innermost = 0;
  uint32_t innermost_reach = 0;
  const auto share_of_link = [&](uint32_t joint, const RobotLink& link, uint32_t reach) {
    return share_of(robot.joints[joint], frames[joint], link, frame_of(frames, link.joint), reach);
  };
  for_each_between(robot, pair, [&](uint32_t joint, uint32_t reach) {
    shares[passed] = share_of_link(joint, passed < pair.joints_a ? a : b, reach);
    ++passed;
    innermost = joint;
    innermost_reach = reach;
  });
  // If one link carries the other, the innermost joint's axis is fixed to the carrier. Relative to
  // the axis, the carrier turns as well, and its points keep their distance from the axis.
  if (pair.joints_a == 0 || pair.joints_b == 0) {
    const RobotLink& carrier = pair.joints_a == 0 ? a : b;
    const uint8_t by_carrier = share_of_link(innermost, carrier, innermost_reach);
    uint8_t& share = shares[passed - 1];
    share = by_carrier < share ? by_carrier : share;
  }
}

uint32_t LeverTravel::fine(uint32_t since) const {
  const uint32_t most = by_reaches_.fine();
  if (turned_ >= kMostTurned) {
    return most;
  }
  // A lever grows by the motion of all joints; this motion, times the turns in radians, is added.
  constexpr uint64_t radians = 25736;  // 2 pi, rounded up, in 2^-12
  const uint64_t grown = (((since * turned_) >> 16) + 1) * radians >> 24;
  const uint64_t sum = by_levers_.fine() + grown + 1;
  return sum < most ? static_cast<uint32_t>(sum) : most;
}

}  // namespace flashbvh::detail
