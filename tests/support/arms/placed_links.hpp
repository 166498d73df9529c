// A robot's links where firmware places them, in cells and doubles, and the reaches between two.
#pragma once

#include <cmath>
#include <vector>

#include "flashbvh/mesh.hpp"
#include "flashbvh/robot/kinematics.hpp"
#include "robot/kinematics.hpp"
#include "robot/matrix/baked_part.hpp"

namespace flashbvh::test {

using tool::Transform;
using tool::Vector3;
using tool::vertices_of;

using Values = std::vector<JointCoordinate>;

/// The coordinates of all joints; empty if the robot refuses the values.
inline Values coordinates_of(const Robot& robot, const Values& values) {
  Values coordinates(robot.joint_count);
  const Status status = set_coordinates(robot, values.data(), coordinates.data());
  return status == Status::done ? coordinates : Values();
}

struct PlacedLinks {
  PlacedLinks(const Robot& of, const Values& coordinates) : robot(of), frames(of.joint_count) {
    set_frames(robot, coordinates.data(), frames.data());
  }
  const Frame& frame_of(std::uint8_t link) const {
    const std::uint8_t joint = robot.links[link].joint;
    return joint == kBase ? kIdentityFrame : frames[joint];
  }
  /// The pose of link `b` in `a`'s frame.
  Pose pose(std::uint8_t a, std::uint8_t b) const {
    return relative_pose(frame_of(a), frame_of(b));
  }

  const Robot& robot;
  std::vector<Frame> frames;
};

/// In cells.
inline Transform transform_of(const Frame& frame) {
  return tool::transform_of(frame, 1);
}
inline Transform transform_of(const Pose& pose) {
  const auto [a, b, c, d, e, f, g, h, i, x, y, z] = tool::pose_numbers(pose, 1);
  return {{{{a, b, c}, {d, e, f}, {g, h, i}}}, {x, y, z}};
}

/// Calls visit(joint, reach) for the joints between two links. `reach`: in 1/256 cell per unit of
/// the joint's coordinate.
template <class Visit>
void for_each_reach(const Robot& robot, const RobotPair& pair, const Visit& visit) {
  const auto inwards = [&](const RobotLink& link, std::uint32_t count) {
    std::uint32_t joint = link.joint;
    for (std::uint32_t i = 0; i < count; ++i) {
      visit(joint, std::ldexp(robot.reaches[link.first_reach + i], -kReachBits));
      joint = robot.joints[joint].parent;
    }
  };
  inwards(robot.links[pair.a], pair.joints_a);
  inwards(robot.links[pair.b], pair.joints_b);
}

}  // namespace flashbvh::test
