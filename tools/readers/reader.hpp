// Common code of the programs that read a form of robots for `flashbvh`. Each takes a file and
// prints the robot as text. `flashbvh` runs them, so that it neither ends by a library's crash or
// exit nor waits for a library to start.
#pragma once

#include <string>

#include "robot/read/robot_text.hpp"

namespace flashbvh::tool {

/// Prints and exits at once: libraries leave memory that leak checkers would report.
[[noreturn]] void print_and_exit(const ReadRobot& read);
/// `message`: the place and the fault.
[[noreturn]] void refuse_and_exit(const std::string& message);

/// The body of main().
[[noreturn]] void run_reader(int argc, char** argv, ReadRobot (*read)(const std::string& path));

/// "arm.xml, joint 'elbow'".
std::string place_of(const std::string& path, const char* kind, const std::string& name);

/// A rotation by a unit quaternion (w, x, y, z), then a translation.
Transform transform_of(const std::array<double, 4>& quaternion, const Vector3& translation);

}  // namespace flashbvh::tool
