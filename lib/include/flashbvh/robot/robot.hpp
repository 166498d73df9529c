// A baked robot: joints, links with their meshes, and the pairs of links that can collide, as
// `flashbvh robot` writes them. Constant arrays in flash, nothing else.
//
// A joint's frame has the joint's axis as its z: its link turns about it, or slides along it. What
// is fixed to a joint (its link, and links that fixed joints hang on it) is baked in the joint's
// frame, so a mesh's pose in the base's frame is its joint's frame.
//
// All meshes share one cell. Lengths are in cells or parts of them.
#ifndef FLASHBVH_ROBOT_ROBOT_HPP
#define FLASHBVH_ROBOT_ROBOT_HPP

#include <stdint.h>

#include "flashbvh/frame.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/plain/robot_parts.h"

namespace flashbvh {

/// plain/robot_parts.h says what each of these is.
using JointCoordinate = flashbvh_joint_coordinate;
using Mount = flashbvh_mount;
using RobotJoint = flashbvh_robot_joint;
using RobotLink = flashbvh_robot_link;
using RobotPair = flashbvh_robot_pair;
using RobotUnguarded = flashbvh_robot_unguarded;
using Robot = flashbvh_robot;

/// What no joint takes: of a float that is no number, or too large.
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

/// Why no guard looks at two links that a joint moves, or not at all of them.
enum class WhyUnguarded : uint8_t {
  zone = FLASHBVH_UNGUARDED_ZONE,
  believed = FLASHBVH_UNGUARDED_BELIEVED,
};

/// In place of a joint's number: what is fixed to the base, the robot's root.
constexpr uint8_t kBase = 0xFF;
/// Fraction bits of a reach: 2 pi 2^6 for each cell of a turning joint's, 2^23 of a sliding one.
constexpr int kReachBits = 26;

/// Joints and links are at most so many each.
constexpr uint32_t kMaxJoints = 64;
constexpr uint32_t kMaxLinks = 64;
/// The largest distance at which two links are kept apart, in 1/256 cell: 32,767 cells.
constexpr uint32_t kMaxGuardDistance = 32'767 * 256;

}  // namespace flashbvh

#endif
