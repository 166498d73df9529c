// Warnings about a decided robot.
#pragma once

#include <string>
#include <vector>

#include "robot/pipeline/divide.hpp"

namespace flashbvh::tool {

/// Warns of pairs that no guard tests, of pairs with their own distances that no joint moves, and
/// of pairs for which a guard would report one verdict in all configurations.
void warn_of_guard(const Divided& robot, const AllDistances& distances, const RobotRequest& request,
                   Warnings& warnings);

/// Warns of joints whose search for a zone ran out of time. `then`: the consequence for the links.
void warn_of_late_zones(const Model& model, const Decided& decided, const std::string& path,
                        const std::string& then, Warnings& warnings);

}  // namespace flashbvh::tool
