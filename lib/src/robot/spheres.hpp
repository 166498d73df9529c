// Spheres round links: they separate far links before any pose is made.
#ifndef FLASHBVH_ROBOT_SPHERES_HPP
#define FLASHBVH_ROBOT_SPHERES_HPP

#include <stdint.h>

#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/robot/robot.hpp"

namespace flashbvh::detail {

/// Of the sphere round a link, in its joint's parent frame: along an axis, in 1/2,048
/// cell, to the nearest.
int64_t centre_of(const RobotLink& link, const Frame& frame, int axis);

/// How far the links' spheres are apart, in 1/256 cell, rounded down; 0 if they intersect.
uint32_t sphere_gap(const RobotLink& a, const Frame& frame_a, const RobotLink& b,
                    const Frame& frame_b);

/// The triangles' distance in 1/256 cell, rounded up by a little: by a cell where they are far
/// apart. Some 7,000 instructions on a Cortex-M4.
uint32_t distance_above(const Triangle& a, const Triangle& b);

}  // namespace flashbvh::detail

#endif
