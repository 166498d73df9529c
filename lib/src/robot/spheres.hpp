// Bounding spheres of links, which separate distant links before a pose is made.
#ifndef FLASHBVH_ROBOT_SPHERES_HPP
#define FLASHBVH_ROBOT_SPHERES_HPP

#include <stdint.h>

#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/robot/robot.hpp"

namespace flashbvh::detail {

/// Centre of a link's bounding sphere, placed by `frame`: its coordinate along an axis, rounded to
/// the nearest 1/2,048 cell.
int64_t centre_of(const RobotLink& link, const Frame& frame, int axis);

/// Distance of two links' bounding spheres, in 1/256 cell, rounded down; 0 if they intersect.
uint32_t sphere_gap(const RobotLink& a, const Frame& frame_a, const RobotLink& b,
                    const Frame& frame_b);

/// Upper bound on two triangles' distance, in 1/256 cell; too large by up to a cell if they are far
/// apart. Some 7,000 instructions on a Cortex-M4.
uint32_t distance_above(const Triangle& a, const Triangle& b);

}  // namespace flashbvh::detail

#endif
