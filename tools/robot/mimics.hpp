// Joints that follow another one's.
#ifndef FLASHBVH_TOOLS_ROBOT_MIMICS_HPP
#define FLASHBVH_TOOLS_ROBOT_MIMICS_HPP

#include <string>
#include <vector>

#include "robot/model.hpp"
#include "robot/urdf_document.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Numbers the variables and says for each joint which one moves it and how, through chains of
/// mimics. A mimic's limits become what its variable's give it: the field ignores its own.
/// `urdf_joints`: of each joint of the Model, its number in the URDF.
void resolve_mimics(const UrdfRobot& robot, const std::vector<std::size_t>& urdf_joints,
                    const std::string& path, std::vector<ModelJoint>& joints,
                    std::vector<std::size_t>& variables, Warnings& warnings);

}  // namespace flashbvh::tool

#endif
