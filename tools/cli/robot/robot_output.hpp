// What `flashbvh robot` prints, and `flashbvh info` of a robot's image: links, joints and pairs, in
// the order of the firmware's arrays.
#pragma once

#include "cli/robot/baked_robot.hpp"
#include "simplify/fit.hpp"

namespace flashbvh::tool {

/// Beyond so many bytes of flash a robot says what leaves of kLargeLeaf triangles save.
constexpr std::size_t kMuchFlash = 1 << 20;

struct RobotFlash {
  std::size_t bytes;                   ///< of the image
  std::optional<std::size_t> smaller;  ///< with leaves of kLargeLeaf, if it is to be said
};

/// What lengths of --simplify cost.
struct RobotLengths {
  const std::vector<simplify::LengthRow>& rows;
  std::vector<std::uint32_t> leaf_sizes;
};

/// Tables on standard output. `lengths`: or null.
void print_robot(const BakedRobot& robot, const RobotFlash& flash, const RobotLengths* lengths);
/// One object on one line.
void print_robot_json(const BakedRobot& robot, const RobotFlash& flash,
                      const RobotLengths* lengths);

/// What is in a robot's image, in the same form.
void print_robot_file(const RobotFile& file);
void print_robot_file_json(const RobotFile& file);

}  // namespace flashbvh::tool
