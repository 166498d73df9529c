// What `flashbvh robot` prints, and `flashbvh info` of a robot's image: links, joints and pairs, in
// the order of the firmware's arrays.
#ifndef FLASHBVH_TOOLS_CLI_ROBOT_OUTPUT_HPP
#define FLASHBVH_TOOLS_CLI_ROBOT_OUTPUT_HPP

#include <string>
#include <vector>

#include "robot/matrix.hpp"
#include "robot/robot_file.hpp"
#include "robot/robot_writer.hpp"

namespace flashbvh::tool {

/// Tables on standard output.
void print_robot(const Model& model, const std::vector<BakedLink>& links, const FixedRobot& robot,
                 const std::vector<PairVerdict>& pairs);
/// One object on one line.
void print_robot_json(const Model& model, const std::vector<BakedLink>& links,
                      const FixedRobot& robot, const std::vector<PairVerdict>& pairs);

/// What is in a robot's image, likewise.
void print_robot_file(const RobotFile& file);
void print_robot_file_json(const RobotFile& file);

}  // namespace flashbvh::tool

#endif
