// What `flashbvh robot` prints, and `flashbvh info` of a robot's image: links, joints and pairs, in
// the order of the firmware's arrays.
#ifndef FLASHBVH_TOOLS_CLI_ROBOT_OUTPUT_HPP
#define FLASHBVH_TOOLS_CLI_ROBOT_OUTPUT_HPP

#include "cli/baked_robot.hpp"

namespace flashbvh::tool {

/// Tables on standard output.
void print_robot(const BakedRobot& robot);
/// One object on one line.
void print_robot_json(const BakedRobot& robot);

/// What is in a robot's image, likewise.
void print_robot_file(const RobotFile& file);
void print_robot_file_json(const RobotFile& file);

}  // namespace flashbvh::tool

#endif
