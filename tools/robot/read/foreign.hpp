// Robots in other forms than URDF: MJCF, which MuJoCo reads, and SDF, which Gazebo reads.
#pragma once

#include <string>
#include <string_view>

#include "robot/read/urdf_document.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Whether a file whose outermost element is `root` is read by a program of its own.
bool is_foreign_form(std::string_view root);

/// Runs the reader of MJCF (`root` "mujoco") or SDF ("sdf") in a process of its own, so that no
/// file crashes or hangs this one. UserError, with the file and the library's message, if it is
/// refused.
UrdfRobot read_foreign(const std::string& path, std::string_view root, Warnings& warnings);

}  // namespace flashbvh::tool
