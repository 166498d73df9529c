// What `flashbvh robot` prints: links, joints and pairs, in the order of the firmware's arrays.
#ifndef FLASHBVH_TOOLS_CLI_ROBOT_OUTPUT_HPP
#define FLASHBVH_TOOLS_CLI_ROBOT_OUTPUT_HPP

#include <string>
#include <vector>

#include "robot/matrix.hpp"
#include "robot/robot_writer.hpp"

namespace flashbvh::tool {

/// Tables on standard output.
void print_robot(const Model& model, const std::vector<BakedLink>& links, const FixedRobot& robot,
                 const std::vector<PairVerdict>& pairs);
/// One object on one line.
void print_robot_json(const Model& model, const std::vector<BakedLink>& links,
                      const FixedRobot& robot, const std::vector<PairVerdict>& pairs);

}  // namespace flashbvh::tool

#endif
