// Reads limits from MoveIt's joint_limits.yaml.
#pragma once

#include <string>

#include "robot/read/urdf_document.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Narrows the limits of the robot's joints to the file's `min_position` and `max_position`, in
/// radians or metres. UserError, with the line and the fix, if the file is malformed or widens a
/// limit; warns of ignored limits. `urdf`: for messages.
void narrow_limits(const std::string& path, const std::string& urdf, UrdfRobot& robot,
                   Warnings& warnings);

}  // namespace flashbvh::tool
