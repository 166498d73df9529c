// Output of `flashbvh robot`, and of `flashbvh info` for a robot's image: links, joints and pairs,
// in the order of the firmware's arrays.
#pragma once

#include "cli/json.hpp"
#include "cli/robot/baked_robot.hpp"

namespace flashbvh::tool {

/// Robots with more bytes of flash print the size with leaves of kLargeLeaf triangles.
constexpr std::size_t kMuchFlash = 1 << 20;

struct RobotFlash {
  std::size_t bytes;                   ///< size of the image
  std::optional<std::size_t> smaller;  ///< with leaves of kLargeLeaf, if to be printed
};

/// Prints tables to standard output.
void print_robot(const BakedRobot& robot, const RobotFlash& flash);
/// The same facts, for --json and pages.
Json robot_json(const BakedRobot& robot, const RobotFlash& flash);

/// Prints a robot's image in the same formats.
void print_robot_file(const RobotFile& file);
void print_robot_file_json(const RobotFile& file);

}  // namespace flashbvh::tool
