#include "robot/replay/posed_pairs.hpp"

#include "flashbvh/robot/robot_float.hpp"

namespace flashbvh::tool {

std::vector<JointCoordinate> coordinates_of(const Robot& robot, const float* floats) {
  std::vector<JointCoordinate> values(robot.variable_count);
  set_values(robot, floats, values.data());
  return values;
}

bool PosedPairs::take(const float* floats) {
  if (set_coordinates(robot_, coordinates_of(robot_, floats).data(), coordinates_.data()) !=
      Status::done) {
    return false;
  }
  set_frames(robot_, coordinates_.data(), frames_.data());
  return true;
}

std::optional<std::uint32_t> PosedPairs::distance_of(std::uint16_t pair) {
  const RobotPair& links = robot_.pairs[pair];
  const Clearance<std::uint16_t> found =
      distance(robot_.meshes[links.a], robot_.meshes[links.b], pose(links), nearest_[pair]);
  if (found.status != Status::done || !found.in_range) {
    return std::nullopt;
  }
  nearest_[pair] = found.witness;
  return found.lower;
}

bool PosedPairs::is_within(std::uint16_t pair, std::uint32_t distance) const {
  const RobotPair& links = robot_.pairs[pair];
  return closer_than(robot_.meshes[links.a], robot_.meshes[links.b], pose(links), distance).yes;
}

}  // namespace flashbvh::tool
