// What of a decided robot its user should know.
#pragma once

#include <string>

#include "cli/robot/robot_arguments.hpp"

namespace flashbvh::tool {

/// Of pairs with distances of their own that no joint moves.
void warn_of_fixed(const BakedRobot& robot, const AllDistances& distances, const std::string& path,
                   Warnings& warnings);

/// Of pairs that no guard looks at.
void warn_of_unguarded(const BakedRobot& robot, const std::string& path, Warnings& warnings);

/// Of pairs of which a guard would say the same wherever the robot stands.
void warn_of_near(const BakedRobot& robot, const AllDistances& distances,
                  const RobotArguments& arguments, Warnings& warnings);

/// Joints whose zone was not found when the time for it was up.
std::vector<std::size_t> late_joints(const BakedRobot& robot, const ZoneRadii& radii);
/// Of these. `then`: what becomes of the links.
void warn_of_late_zones(const BakedRobot& robot, const std::string& path, const std::string& then,
                        Warnings& warnings);

}  // namespace flashbvh::tool
