// Converts floats of encoder drivers and trajectories to joint coordinates and frames.
//
// Optional, as float.hpp, and also without float arithmetic: a coordinate is equal on every core.
#pragma once

#include <stdint.h>

#include "flashbvh/float.hpp"
#include "flashbvh/robot/robot.hpp"
#include "flashbvh/units.hpp"

namespace flashbvh {

/// Converts an angle in radians, rounded to 2^-28 of a turn (23 nanoradians). Returns kNoCoordinate
/// if it is not a number, or 8 turns or more: the caller reduces angles of joints without limits.
inline JointCoordinate angle_coordinate(float radians) {
  constexpr uint64_t per_radian = 0xA2F9836E4E44152Au;  // 2^28 / (2 pi), in 2^-38
  constexpr int bits = 38;
  const detail::FloatParts parts = detail::parts_of(radians);
  const uint64_t low = uint64_t{parts.digits} * static_cast<uint32_t>(per_radian);
  const uint64_t upper = uint64_t{parts.digits} * (per_radian >> 32) + (low >> 32);  // 32 bits less
  const int shift = bits - parts.exponent - 32;
  if (!parts.is_finite || shift < 23) {  // 64 radians
    return kNoCoordinate;
  }
  const uint64_t units = shift > 60 ? 0 : (upper + (uint64_t{1} << (shift - 1))) >> shift;
  if (units > INT32_MAX) {
    return kNoCoordinate;
  }
  return static_cast<JointCoordinate>(parts.is_negative ? -static_cast<int64_t>(units)
                                                        : static_cast<int64_t>(units));
}

namespace detail {

/// Converts a length in metres, rounded to 1/2,048 cell, halves up: off by half a unit and 2^-8 at
/// most. Returns kNoCoordinate if it is not a number, or 2^19 cells or more.
inline JointCoordinate slide_coordinate(float length, const CellsPerUnit& cells) {
  const FloatParts parts = parts_of(length);
  const uint64_t product = parts.digits * cells.digits;  // below 2^63; from 2^38 on, unless 0
  const int shift = -(parts.exponent + cells.exponent + kFrameBits);
  if (!parts.is_finite || (product != 0 && shift <= 0)) {
    return kNoCoordinate;
  }
  const uint64_t half = shift > 0 && shift < 64 ? uint64_t{1} << (shift - 1) : 0;
  const uint64_t units = half == 0 ? 0 : (product + half - (parts.is_negative ? 1 : 0)) >> shift;
  if (units > kMaxJointCoordinate) {
    return kNoCoordinate;
  }
  return parts.is_negative ? -static_cast<JointCoordinate>(units)
                           : static_cast<JointCoordinate>(units);
}

inline Status set_translation(const Robot& robot, const float (&metres)[3], Frame& frame) {
  if (!is_usable(robot)) {
    return Status::not_open;
  }
  const CellsPerUnit cells = exact_cells_per_unit(robot.cell_bits);
  bool fits = true;
  for (int axis = 0; axis < 3; ++axis) {
    frame.translation[axis] = slide_coordinate(metres[axis], cells);
    fits = fits && frame.translation[axis] != kNoCoordinate;
  }
  return fits ? Status::done : Status::translation_out_of_range;
}

}  // namespace detail

/// Makes a frame from a matrix, row by row, and metres. `translation_out_of_range`; `not_open`.
/// Functions that use the frame test if the matrix is a rotation.
inline Status set_frame(const Robot& robot, const float (&rotation)[3][3], const float (&metres)[3],
                        Frame& frame) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      frame.rotation[i][j] = detail::rotation_entry(rotation[i][j]);
    }
  }
  return detail::set_translation(robot, metres, frame);
}

/// Makes a frame from a unit quaternion (float.hpp) and metres.
inline Status set_frame(const Robot& robot, const UnitQuaternion& rotation,
                        const float (&metres)[3], Frame& frame) {
  detail::set_rotation(rotation, frame.rotation);
  return detail::set_translation(robot, metres, frame);
}

/// Converts all values of a robot: radians, and metres for prismatic joints. `floats` and `values`:
/// variable_count each. For a float that is no valid coordinate, functions that use the values
/// return `not_a_coordinate`.
inline void set_values(const Robot& robot, const float* floats, JointCoordinate* values) {
  const detail::CellsPerUnit cells = detail::exact_cells_per_unit(robot.cell_bits);
  for (uint32_t i = 0; i < robot.joint_count; ++i) {
    const RobotJoint& joint = robot.joints[i];
    const uint32_t variable = joint.variable;
    if (joint.shift == 0) {  // no mimic
      values[variable] = joint.type == JointType::prismatic
                             ? detail::slide_coordinate(floats[variable], cells)
                             : angle_coordinate(floats[variable]);
    }
  }
}

}  // namespace flashbvh
