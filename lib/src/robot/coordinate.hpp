// Joints' coordinates.
#ifndef FLASHBVH_ROBOT_COORDINATE_HPP
#define FLASHBVH_ROBOT_COORDINATE_HPP

#include <stdint.h>

#include "../lattice/fixed_point.hpp"
#include "flashbvh/robot/robot.hpp"

namespace flashbvh::detail {

constexpr int kTurnBits = 28;
static_assert(kFullTurn == 1 << kTurnBits, "one meaning of a turn");

/// The same angle, from -1/2 turn to less than 1/2.
constexpr int32_t wrapped(int32_t angle) {
  return static_cast<int32_t>(static_cast<uint32_t>(angle) << (32 - kTurnBits)) >> (32 - kTurnBits);
}

/// Differences that 32 bits may not hold: of a state that was damaged while it was stored.
constexpr int32_t difference(int32_t u, int32_t v) {
  return static_cast<int32_t>(static_cast<uint32_t>(u) - static_cast<uint32_t>(v));
}

/// How far two coordinates are apart.
constexpr uint32_t apart(int32_t u, int32_t v) {
  return u < v ? static_cast<uint32_t>(v) - static_cast<uint32_t>(u)
               : static_cast<uint32_t>(u) - static_cast<uint32_t>(v);
}

constexpr uint32_t greater(uint32_t u, uint32_t v) {
  return u > v ? u : v;
}

/// Whether the guard's joint can stand there. Joints without limits are kept within a turn of 0.
constexpr bool can_be_at(const RobotJoint& joint, JointCoordinate coordinate) {
  return joint.type == JointType::continuous
             ? coordinate >= -kFullTurn && coordinate <= kFullTurn
             : coordinate >= joint.lower && coordinate <= joint.upper;
}

/// Where the caller's values put the joint; where that would be beyond 32 bits, limited joints to
/// the end of the range, others so many turns back. What is fixed has no value: where an obstacle
/// is moved, its joint counts how far.
inline JointCoordinate coordinate_of(const RobotJoint& joint, const JointCoordinate* values) {
  if (joint.type == JointType::fixed) {
    return joint.offset;
  }
  const JointCoordinate value = values[joint.variable];
  if (joint.shift == 0) {
    return value;
  }
  const int64_t moved = static_cast<int64_t>(value) * joint.multiplier;
  const int64_t at = ((moved + (int64_t{1} << (joint.shift - 1))) >> joint.shift) + joint.offset;
  if (joint.type == JointType::continuous) {
    return wrapped(static_cast<int32_t>(static_cast<uint32_t>(at)));
  }
  return static_cast<JointCoordinate>(at > INT32_MAX ? INT32_MAX : at < INT32_MIN ? INT32_MIN : at);
}

}  // namespace flashbvh::detail

#endif
