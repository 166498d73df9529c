// What programs that read a form of robots for `flashbvh` have in common. Each takes a file and
// prints the robot as text; `flashbvh` runs them, so that a library that crashes or exits takes
// neither it nor its time to start.
#pragma once

#include <string>

#include "robot/read/robot_text.hpp"

namespace flashbvh::tool {

/// Prints and ends at once: libraries leave memory that leak checkers would report.
[[noreturn]] void print_and_exit(const ReadRobot& read);
/// `message`: place and what is wrong there.
[[noreturn]] void refuse_and_exit(const std::string& message);

/// The whole of main().
[[noreturn]] void run_reader(int argc, char** argv, ReadRobot (*read)(const std::string& path));

/// "arm.xml, joint 'elbow'".
std::string place_of(const std::string& path, const char* kind, const std::string& name);

/// Rotated by a unit quaternion (w, x, y, z).
Transform transform_of(const std::array<double, 4>& quaternion, const Vector3& translation);

}  // namespace flashbvh::tool
