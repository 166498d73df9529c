// Output of `flashbvh robot`, and of `flashbvh info` for a robot's image: links, joints and pairs,
// in the order of the firmware's arrays.
#pragma once

#include "cli/table.hpp"
#include "robot/baked/robot_file.hpp"
#include "robot/pipeline/baked_robot.hpp"

namespace flashbvh::tool {

/// The largest distance in metres of a point of a link from the meshes that it was baked from.
double links_deviation(const Robot& robot);
/// What simplified links, which deviate by so many metres, do to a guard.
std::string early_text(double deviation);

/// The values of the variables at a pair's witness.
Json witness_json(const Model& model, const PairVerdict& pair);

/// The facts of a baked robot, for --json and pages. `bytes`: of the image.
Json robot_json(const BakedRobot& robot, std::size_t bytes);
/// Prints tables of these facts to standard output.
void print_robot(const BakedRobot& robot, const Json& json);

/// Prints a robot's image in the same forms.
void print_robot_file(const RobotFile& file, bool json);

}  // namespace flashbvh::tool
