// Arms as firmware holds them, with their kinematics in doubles at equal values.
#pragma once

#include <cmath>

#include "flashbvh/clearance.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "support/arms/arms.hpp"
#include "support/arms/placed_links.hpp"

namespace flashbvh::test {

/// The model as the reader returns it: a mimic of a joint without limits has none, either.
inline Model as_read(Model model) {
  for (tool::ModelJoint& joint : model.joints) {
    const tool::ModelJoint& master = model.joints[model.variables[joint.variable]];
    if (master.type == JointType::continuous && &master != &joint) {
      joint.type = JointType::continuous;
      joint.multiplier = std::round(joint.multiplier);
    }
  }
  return model;
}

struct FixedArm {
  FixedArm(const Model& made, double cell, const std::vector<tool::GuardedPair>& pairs = {},
           bool has_distance_tables = false)
      : model(as_read(made)),
        arm(model, cell),
        fixed(model, arm.wholes(), arm.meshes(), cell, pairs) {
    if (has_distance_tables) {
      fixed.set_distance_tables(distance_tables_of(model, robot()));
    }
  }

  const Robot& robot() const { return fixed.robot(); }
  double unit_of(std::size_t variable) const {
    return tool::unit_of_coordinate(joint_of(variable).type, arm.cell());
  }
  std::vector<double> variables(const Values& values) const {
    std::vector<double> reals;
    for (std::size_t i = 0; i < values.size(); ++i) {
      reals.push_back(values[i] * unit_of(i));
    }
    return reals;
  }
  const RobotJoint& joint_of(std::size_t variable) const {
    return robot().joints[model.variables[variable]];
  }
  bool is_free(std::size_t variable) const {
    return joint_of(variable).type == JointType::continuous;
  }
  /// The frame of the pair's link b in a's frame, by exact kinematics, rounded to a pose.
  Pose exact_pose(const RobotPair& pair, const Values& values) const {
    const tool::JointsBetween between = joints_between(model, pair.a, pair.b);
    return tool::pose_of(frame_between(model, between, variables(values)), arm.cell());
  }
  /// In 1/256 cell. False: the distance is at least `distance` less the error of placing.
  bool is_closer(const RobotPair& pair, const Values& values, std::uint32_t distance) const {
    return closer_than(robot().meshes[pair.a], robot().meshes[pair.b], exact_pose(pair, values),
                       {distance < kMaxGuardDistance ? distance : kMaxGuardDistance})
        .yes;
  }
  /// Random values within the limits, sometimes at them.
  Values any_values(Random& random) const {
    Values values;
    for (std::size_t i = 0; i < model.variables.size(); ++i) {
      const RobotJoint& joint = joint_of(i);
      const std::uint32_t kind = random.below(16);
      values.push_back(is_free(i)  ? random.between(-2 * kFullTurn, 2 * kFullTurn)
                       : kind == 0 ? joint.lower
                       : kind == 1 ? joint.upper
                                   : random.between(joint.lower, joint.upper));
    }
    return values;
  }

  Model model;
  BakedArm arm;
  tool::FixedRobot fixed;
};

}  // namespace flashbvh::test
