// Robots in other forms than URDF: MJCF, which MuJoCo reads, and SDF, which Gazebo reads.
#pragma once

#include <string>
#include <string_view>

#include "robot/read/urdf_document.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// True if a separate program reads files whose outermost element is `root`.
bool is_foreign_form(std::string_view root);

/// Runs the reader of MJCF (`root` "mujoco") or SDF ("sdf") in a separate process, so that no file
/// crashes or hangs this one. UserError, with the file and the library's message, if the reader
/// refuses the file.
UrdfRobot read_foreign(const std::string& path, std::string_view root, Warnings& warnings);

}  // namespace flashbvh::tool
