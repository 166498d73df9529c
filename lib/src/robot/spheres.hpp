// Bounding spheres of links, which separate distant links before a pose is made.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/robot/robot.hpp"

namespace flashbvh::detail {

/// Centre of a link's bounding sphere, placed by `frame`: its coordinate along an axis, rounded to
/// the nearest 1/2,048 cell.
int64_t centre_of(const RobotLink& link, const Frame& frame, int axis);

/// The reach of a point that is `lever` 1/2,048 cells away from a joint's axis, rounded up.
constexpr uint32_t reach_at(uint64_t lever) {
  return static_cast<uint32_t>((12868 * lever + 0xFFFF) >> 16);  // pi/16, rounded up, in 2^-16
}

/// Distance of two links' bounding spheres, in 1/256 cell, rounded down; 0 if they intersect.
uint32_t sphere_gap(const RobotLink& a, const Frame& frame_a, const RobotLink& b,
                    const Frame& frame_b);

/// Upper bound on two triangles' distance, in 1/256 cell; too large by up to a cell if they are far
/// apart. Some 7,000 instructions on a Cortex-M4.
uint32_t distance_above(const Triangle& a, const Triangle& b);

}  // namespace flashbvh::detail
