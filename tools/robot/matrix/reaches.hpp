// How far joints move links: Schwarzer, Saha and Latombe, "Adaptive Dynamic Collision Checking for
// Single and Multiple Articulated Robots in Complex Environments", IEEE Transactions on Robotics
// 21(3), 2005.
//
// As joint k turns by an angle w, a point that lies r from its axis moves by r w at most. So seen
// from any body between links a and b, no point of a moves by more than the sum of reach times
// change over the joints between it and that body, whichever way they get there.
#pragma once

#include <vector>

#include "robot/kinematics.hpp"
#include "robot/matrix/deadline.hpp"

namespace flashbvh::tool {

/// How far rounding to the lattice moves a vertex at most, in cells: half the diagonal of a cell,
/// and what doubles round.
constexpr double kDeviation = 0.8661;

/// [joint]: how far any point of the link, rounded to the lattice, can lie from the joint's axis,
/// in metres, over all settings within the limits of the joints between them; 1 for prismatic
/// joints. Of any joint: on the link's branch, beyond it or on another one. Never below the truth;
/// above it by some parts in a thousand where joints don't depend on each other.
/// Beyond twelve joints, and where there is no time, it is only known to lie in a ball.
std::vector<double> reaches_of(const Model& model, std::size_t link, double cell,
                               const Deadline& deadline = {});

/// Of each link. On all processors.
using Reaches = std::vector<std::vector<double>>;
Reaches all_reaches(const Model& model, double cell, const Deadline& deadline = {});

}  // namespace flashbvh::tool
