// A baked robot: joints, links with their meshes, and the pairs of links that can collide, as
// `flashbvh robot` writes them. Constant arrays in flash.
//
// A joint's frame has the joint's axis as its z: the link turns about it, or slides along it.
// Bodies fixed to a joint (its link, and links on fixed joints) are baked in the joint's frame. So
// a mesh's pose in the base's frame is its joint's frame.
//
// All meshes share one cell. Lengths are in cells or parts of them.
#pragma once

#include <stdint.h>

#include "flashbvh/mesh.hpp"
#include "flashbvh/plain/robot_parts.h"
#include "flashbvh/pose.hpp"

namespace flashbvh {

/// plain/robot_parts.h describes these types.
using JointCoordinate = flashbvh_joint_coordinate;
using Mount = flashbvh_mount;
using RobotJoint = flashbvh_robot_joint;
using RobotLink = flashbvh_robot_link;
using RobotPair = flashbvh_robot_pair;
using RobotUnguarded = flashbvh_robot_unguarded;
using Robot = flashbvh_robot;

/// An invalid coordinate: the result for a float that is not a number, or too large.
constexpr JointCoordinate kNoCoordinate = INT32_MIN;
/// Largest magnitude of a limit: 4 turns, or 2^19 cells. Differences of coordinates fit 32 bits.
constexpr JointCoordinate kMaxJointCoordinate = 1 << 30;

/// How a joint moves.
enum class JointType : uint8_t {
  revolute = FLASHBVH_JOINT_REVOLUTE,
  continuous = FLASHBVH_JOINT_CONTINUOUS,
  prismatic = FLASHBVH_JOINT_PRISMATIC,
  fixed = FLASHBVH_JOINT_FIXED,
};

/// Reasons why no guard checks two links that a joint moves, or not all of them.
enum class WhyUnguarded : uint8_t {
  zone = FLASHBVH_UNGUARDED_ZONE,
  believed = FLASHBVH_UNGUARDED_BELIEVED,
};

/// In place of a joint's number: the base, the robot's root.
constexpr uint8_t kBase = 0xFF;
/// Fraction bits of a reach. Each cell of a revolute joint's lever arm is 2 pi 2^6; a prismatic
/// joint's reach is 2^23.
constexpr int kReachBits = 26;

/// Largest numbers of joints and links.
constexpr uint32_t kMaxJoints = 64;
constexpr uint32_t kMaxLinks = 255;
/// The largest distance at which two links are kept apart, in 1/256 cell: 32,767 cells.
constexpr uint32_t kMaxGuardDistance = 32'767 * 256;

namespace detail {

/// True if guards, motions and workcells may use the robot. A robot of zeros has none of these.
inline bool is_open(const Robot& robot) {
  return robot.joint_count != 0 && robot.hash != 0 && is_usable(robot);
}

/// Whether an object has a robot and enough memory for it. A word: guards' checksums read words.
/// An object of zeros, which no constructor made, is not open.
enum class Fit : uint32_t { not_open, fits, too_small };

inline Fit fit_of(const Robot& robot, bool is_large_enough) {
  return !is_open(robot) ? Fit::not_open : is_large_enough ? Fit::fits : Fit::too_small;
}

/// `done`; `not_open`, also if the robot is open no longer; or `guard_state_invalid`.
inline Status status_of(Fit fit, const Robot* robot) {
  return fit == Fit::too_small                 ? Status::guard_state_invalid
         : fit == Fit::fits && is_open(*robot) ? Status::done
                                               : Status::not_open;
}

}  // namespace detail
}  // namespace flashbvh
