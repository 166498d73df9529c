// Bounds on how far joints move links: Schwarzer, Saha and Latombe, "Adaptive Dynamic Collision
// Checking for Single and Multiple Articulated Robots in Complex Environments", IEEE Transactions
// on Robotics 21(3), 2005.
//
// If joint k turns by an angle w, a point at distance r from its axis moves by r w at most. Let
// joints move along any path. Seen from any body between links a and b, a point of a then moves by
// at most the sum of reach times change over the joints between a and that body.
#pragma once

#include <vector>

#include "robot/kinematics.hpp"
#include "text/deadline.hpp"

namespace flashbvh::tool {

/// A bound on a vertex's motion by rounding to the lattice, in cells: half the diagonal of a cell,
/// and the rounding of doubles.
constexpr double kDeviation = 0.8661;

/// [joint]: a bound on the distance of the link's points, rounded to the lattice, from the joint's
/// axis, in metres; 1 for prismatic joints. Holds for all values within the limits of the joints
/// between. The joint may be on the link's branch, beyond it or on another one. Never too low; too
/// high by some parts in a thousand if joints are independent. Beyond twelve joints, or when time
/// is up, the link is only bounded by a ball.
std::vector<double> reaches_of(const Model& model, std::size_t link, double cell,
                               const Deadline& deadline = {});

/// One vector per link. Uses all processors.
using Reaches = std::vector<std::vector<double>>;
Reaches all_reaches(const Model& model, double cell, const Deadline& deadline = {});

}  // namespace flashbvh::tool
