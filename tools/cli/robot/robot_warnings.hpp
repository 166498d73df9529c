// Warnings about a decided robot.
#pragma once

#include <string>

#include "cli/robot/robot_arguments.hpp"

namespace flashbvh::tool {

/// Warns of pairs with their own distances that no joint moves.
void warn_of_fixed(const BakedRobot& robot, const AllDistances& distances, const std::string& path,
                   Warnings& warnings);

/// Warns of pairs that no guard tests.
void warn_of_unguarded(const BakedRobot& robot, const std::string& path, Warnings& warnings);

/// Warns of pairs for which a guard would report one verdict in all configurations.
void warn_of_near(const BakedRobot& robot, const AllDistances& distances,
                  const RobotArguments& arguments, Warnings& warnings);

/// Warns of joints whose search for a zone ran out of time. `then`: the consequence for the links.
void warn_of_late_zones(const BakedRobot& robot, const std::string& path, const std::string& then,
                        Warnings& warnings);

}  // namespace flashbvh::tool
