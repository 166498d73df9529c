// Where a robot's joints and links are, in fixed point: the same bits on every core.
#ifndef FLASHBVH_ROBOT_KINEMATICS_HPP
#define FLASHBVH_ROBOT_KINEMATICS_HPP

#include <stdint.h>

#include "flashbvh/pose.hpp"
#include "flashbvh/robot/robot.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// A joint's coordinate from the caller's values. `done`; `not_a_coordinate` for kNoCoordinate;
/// `joint_out_of_limits`. Continuous joints take any other value.
[[nodiscard]] Status set_coordinates(const Robot& robot, const JointCoordinate* values,
                                     JointCoordinate* coordinates) noexcept;

/// The frames of all joints in the base's frame: `frames` takes joint_count of them.
///
/// Each joint on the way adds at most 2^-27 to the norm of the error of the rotation, and 1/1,024
/// cell to that of the translation: Robot::slack has it. Instructions on a Cortex-M4 at -O2: some
/// 500 a joint.
void set_frames(const Robot& robot, const JointCoordinate* coordinates, Frame* frames) noexcept;

/// First `inner`, then `outer`: the frame of B in C's from B's in A's and A's in C's.
[[nodiscard]] Frame composed(const Frame& outer, const Frame& inner) noexcept;

/// B in A's frame, from both in another one: as queries take it.
[[nodiscard]] Pose relative_pose(const Frame& a, const Frame& b) noexcept;

}  // namespace flashbvh

#endif
