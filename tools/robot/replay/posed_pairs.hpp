// The poses and distances of a robot's pairs of links at the values of a period.
#ifndef FLASHBVH_TOOLS_ROBOT_REPLAY_POSED_PAIRS_HPP
#define FLASHBVH_TOOLS_ROBOT_REPLAY_POSED_PAIRS_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/kinematics.hpp"

namespace flashbvh::tool {

/// The coordinates of the variables, as firmware makes them of floats.
std::vector<JointCoordinate> coordinates_of(const Robot& robot, const float* floats);

class PosedPairs {
 public:
  /// `robot` outlives it.
  explicit PosedPairs(const Robot& robot)
      : robot_(robot),
        coordinates_(robot.joint_count),
        frames_(robot.joint_count),
        nearest_(robot.pair_count) {}

  /// False if firmware refuses the values.
  bool take(const float* floats);

  Pose pose(const RobotPair& pair) const {
    return relative_pose(frame_of(pair.a), frame_of(pair.b));
  }
  Pose pose(std::uint8_t link) const { return relative_pose(kIdentityFrame, frame_of(link)); }

  /// In 1/256 cell, rounded down; none if it is out of range. The last one is the hint.
  std::optional<std::uint32_t> distance_of(std::uint16_t pair);
  bool is_within(std::uint16_t pair, std::uint32_t distance) const;

 private:
  const flashbvh::Frame& frame_of(std::uint8_t link) const {
    const std::uint8_t joint = robot_.links[link].joint;
    return joint == kBase ? kIdentityFrame : frames_[joint];
  }

  const Robot& robot_;
  std::vector<JointCoordinate> coordinates_;
  std::vector<flashbvh::Frame> frames_;
  std::vector<Witness<std::uint16_t>> nearest_;  ///< of each pair
};

}  // namespace flashbvh::tool

#endif
