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

#include "flashbvh/mesh.hpp"
#include "flashbvh/robot/frame.hpp"

namespace flashbvh {

/// Where a joint stands: of one that turns, in 2^-28 of a turn; of one that slides, in 1/2,048
/// cell.
using JointCoordinate = int32_t;
/// A full turn.
constexpr JointCoordinate kFullTurn = 1 << 28;
/// What no joint takes: of a float that is no number, or too large.
constexpr JointCoordinate kNoCoordinate = INT32_MIN;
/// Largest magnitude of a limit: 4 turns, or 2^19 cells. Differences of coordinates fit 32 bits.
constexpr JointCoordinate kMaxJointCoordinate = 1 << 30;

/// How a joint moves.
enum class JointType : uint8_t {
  revolute = 0,
  continuous = 1,  ///< revolute, without limits: coordinates a full turn apart are the same
  prismatic = 2,
  /// Carries a body that was added to a robot (workcell.hpp): no value of the caller's moves it.
  fixed = 3,
};

/// In place of a joint's number: what is fixed to the base, the robot's root.
constexpr uint8_t kBase = 0xFF;
/// Fraction bits of a reach: 2 pi 2^6 for each cell of a turning joint's, 2^23 of a sliding one.
constexpr int kReachBits = 26;

/// Where something is fastened to a robot: in the frame that a joint carries, or in the base's. A
/// robot's header has those of all links of its URDF, with geometry or without.
struct Mount {
  uint8_t joint;  ///< or kBase
  Frame frame;
};

/// Joints and links are at most so many each.
constexpr uint32_t kMaxJoints = 64;
constexpr uint32_t kMaxLinks = 64;

/// 72 bytes.
struct RobotJoint {
  Frame fixed;            ///< its frame in its parent's, at coordinate 0
  JointCoordinate lower;  ///< limits, both allowed; of a continuous joint 0 and not looked at
  JointCoordinate upper;
  /// Of a joint that mimics another one, whose value is the caller's: its coordinate is
  /// (value * multiplier >> shift) + offset, rounded to the nearest. Else `shift` is 0.
  int32_t multiplier;
  JointCoordinate offset;
  uint8_t shift;     ///< 0, or 1 to 40
  uint8_t parent;    ///< a joint before it, or kBase
  uint8_t variable;  ///< which of the caller's values moves it
  JointType type;
  uint32_t padding;
};

/// A body: what of the robot has a mesh. 24 bytes. The mesh is that of the same number.
struct RobotLink {
  /// A sphere that holds the mesh: centre in the joint's frame and radius, in 1/2,048 cell.
  int32_t centre[3];
  uint32_t radius;
  /// Of Robot::reaches: the first of those of its branch, from its own joint to the base.
  uint16_t first_reach;
  uint8_t joint;  ///< or kBase
  uint8_t padding[5];
};

/// Two links that can collide. 16 bytes.
struct RobotPair {
  uint32_t stop;  ///< distances, in 1/256 cell
  uint32_t warn;  ///< at least `stop`
  /// The sum of the reaches of all joints between the two; fits 32 bits.
  uint32_t reach;
  uint8_t a;  ///< links
  uint8_t b;
  /// How many joints of a's branch, from its own inwards, are not of b's; and the other way round.
  uint8_t joints_a;
  uint8_t joints_b;
};

/// Why no guard looks at two links that a joint moves.
enum class WhyUnguarded : uint8_t {
  intersecting = 0,  ///< neighbours that intersect at all configurations tried
  believed = 1,      ///< they may collide, but an SRDF disables the pair and --believe names it
};

/// Two links that a joint moves and that no guard looks at: a collision of the two is never
/// detected. 4 bytes.
struct RobotUnguarded {
  uint8_t a;  ///< links
  uint8_t b;
  WhyUnguarded why;
  uint8_t padding;
};

/// A view of arrays that outlive it.
struct Robot {
  const RobotJoint* joints;  ///< joint_count, parents before children
  const RobotLink* links;    ///< link_count
  const PostMesh* meshes;    ///< link_count
  const RobotPair* pairs;    ///< pair_count
  /// How far a joint moves any point of a link, whatever the joints between the two: in
  /// 2^-kReachBits of 1/256 cell a unit of the joint's coordinate, rounded up.
  const uint32_t* reaches;
  /// Of pairs with one or two joints between: how far apart at least, by where these stand; bytes.
  const uint8_t* charts;
  uint8_t joint_count;
  uint8_t link_count;
  uint8_t variable_count;  ///< how many values the caller gives
  uint8_t padding;
  uint16_t pair_count;
  uint16_t reach_count;
  /// How far two of its links, as the URDF has them, may be nearer to each other than their placed
  /// meshes, in 1/256 cell: what rounding vertices to the lattice, when they are baked and when
  /// they are placed, and kinematics in fixed point add up to.
  uint32_t slack;
  uint32_t chart_bytes;  ///< 0: a guard does without
  uint32_t hash;         ///< of all of it: tells robots apart
  uint64_t cell_bits;    ///< the cell in metres, as the bits of an IEEE binary64
};

}  // namespace flashbvh

#endif
