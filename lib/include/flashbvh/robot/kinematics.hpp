// Frames of a robot's joints and links in fixed point: equal bits on every core.
#pragma once

#include <stdint.h>

#include "flashbvh/pose.hpp"
#include "flashbvh/robot/robot.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// Computes all joints' coordinates from the caller's values. `done`; `not_a_coordinate` for
/// kNoCoordinate; `joint_out_of_limits`; `not_open`. Continuous joints take any other value.
[[nodiscard]] Status set_coordinates(const Robot& robot, const JointCoordinate* values,
                                     JointCoordinate* coordinates) noexcept;

/// Computes the frames of all joints in the base's frame: `frames` has joint_count entries.
///
/// Each joint from the base on adds at most 2^-27 to the norm of the rotation's error and 1/1,024
/// cell to the translation's; Robot::slack includes that. About 500 instructions a joint on a
/// Cortex-M4 at -O2.
void set_frames(const Robot& robot, const JointCoordinate* coordinates, Frame* frames) noexcept;

/// Applies `inner`, then `outer`: returns B's frame in C's from B's in A's and A's in C's. A
/// translation beyond 32 bits saturates; beyond kMaxFrameTranslation the result is no valid frame.
[[nodiscard]] Frame composed(const Frame& outer, const Frame& inner) noexcept;

/// Returns B's pose in A's frame, for queries, from both frames in an outer one. Its status is
/// `translation_out_of_range` if a difference of their translations, 2^20 cells, exceeds 32 bits.
[[nodiscard]] Pose relative_pose(const Frame& a, const Frame& b) noexcept;

}  // namespace flashbvh
