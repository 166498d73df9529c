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

}  // namespace flashbvh::tool
