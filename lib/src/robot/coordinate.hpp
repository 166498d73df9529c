// Coordinates of joints.
#pragma once

#include <stdint.h>

#include "../lattice/fixed_point.hpp"
#include "flashbvh/robot/robot.hpp"

namespace flashbvh::detail {

constexpr int kTurnBits = 28;
static_assert(kFullTurn == 1 << kTurnBits, "one meaning of a turn");

/// Wraps an angle to the range from -1/2 turn to less than 1/2 turn.
constexpr int32_t wrapped(int32_t angle) {
  return static_cast<int32_t>(static_cast<uint32_t>(angle) << (32 - kTurnBits)) >> (32 - kTurnBits);
}

/// A difference modulo 2^32, as the coordinates of a damaged state may overflow.
constexpr int32_t difference(int32_t u, int32_t v) {
  return static_cast<int32_t>(static_cast<uint32_t>(u) - static_cast<uint32_t>(v));
}

/// An obstacle's path in laps of 2^24, in 1/256 cell. Guards keep the sum over all obstacles,
/// modulo 2^24 laps: in coordinates alone, a path of 2^32 between two periods looks like none.
constexpr int kLapBits = 24;
constexpr uint32_t kLapMask = (1u << 24) - 1;
/// An obstacle that moved by 2^31, which no coordinate's step holds, passed so many laps.
constexpr uint32_t kTooManyLaps = 1u << (31 - kLapBits);
/// While the sum's quotient by this is constant, no obstacle moves by more than 2^30 and a lap.
constexpr int kLapsOfWalkBits = 30 - kLapBits;

/// Moves a path's end on; `moved` is below 2^28.
inline void add_path(RobotJoint& obstacle, uint32_t moved) {
  const auto before = static_cast<uint32_t>(obstacle.offset);
  const uint32_t now = before + moved;
  obstacle.offset = static_cast<int32_t>(now);
  obstacle.laps += ((now >> kLapBits) - (before >> kLapBits)) & (UINT32_MAX >> kLapBits);
}

/// Absolute difference of two coordinates.
constexpr uint32_t apart(int32_t u, int32_t v) {
  return u < v ? static_cast<uint32_t>(v) - static_cast<uint32_t>(u)
               : static_cast<uint32_t>(u) - static_cast<uint32_t>(v);
}

constexpr uint32_t greater(uint32_t u, uint32_t v) {
  return u > v ? u : v;
}

/// Returns whether a guard's joint can have a coordinate. Joints without limits stay within a turn.
constexpr bool can_be_at(const RobotJoint& joint, JointCoordinate coordinate) {
  return joint.type == JointType::continuous
             ? coordinate >= -kFullTurn && coordinate <= kFullTurn
             : coordinate >= joint.lower && coordinate <= joint.upper;
}

/// A joint's coordinate from the caller's values. Beyond 32 bits it saturates if the joint has
/// limits, and else wraps. A fixed joint has no value; an obstacle's counts how far it was moved.
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
