#include "robot/kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "evaluate/poses.hpp"

namespace flashbvh::tool {
namespace {

/// The joints from `joint` to the base.
std::vector<std::size_t> branch_of(const Model& model, std::size_t joint) {
  std::vector<std::size_t> branch;
  for (; joint != kNoJoint; joint = model.joints[joint].parent) {
    branch.push_back(joint);
  }
  return branch;
}

/// A joint's coordinate, in radians or metres. `variables`: one value each.
double coordinate_of(const ModelJoint& joint, const std::vector<double>& variables) {
  return joint.multiplier * variables[joint.variable] + joint.offset;
}

/// The joint's motion at `coordinate`, in the joint's frame at 0.
Transform motion_of(const ModelJoint& joint, double coordinate) {
  Transform motion;
  if (joint.type == JointType::prismatic) {
    motion.translation[2] = coordinate;
    return motion;
  }
  const double c = std::cos(coordinate);
  const double s = std::sin(coordinate);
  motion.rotation = {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
  return motion;
}

}  // namespace

Interval range_of_variable(const Model& model, std::size_t variable) {
  const ModelJoint& joint = model.joints[model.variables[variable]];
  const auto margin = [](double limit) { return 0x1p-22 * std::max(1.0, std::abs(limit)); };
  return joint.type == JointType::continuous
             ? Interval{joint.lower, joint.upper}
             : Interval{joint.lower - margin(joint.lower), joint.upper + margin(joint.upper)};
}

Interval range_of_joint(const Model& model, std::size_t number) {
  const ModelJoint& joint = model.joints[number];
  const Interval range = range_of_variable(model, joint.variable);
  const double one = joint.multiplier * range.lower + joint.offset;
  const double other = joint.multiplier * range.upper + joint.offset;
  return {std::min(one, other), std::max(one, other)};
}

std::vector<Transform> frames_of(const Model& model, const std::vector<double>& variables) {
  std::vector<Transform> frames;
  for (const ModelJoint& joint : model.joints) {
    const Transform parent = joint.parent == kNoJoint ? Transform() : frames[joint.parent];
    const Transform motion = motion_of(joint, coordinate_of(joint, variables));
    frames.push_back(composed(composed(parent, joint.fixed), motion));
  }
  return frames;
}

JointsBetween joints_between(const Model& model, std::size_t link_a, std::size_t link_b) {
  JointsBetween joints = {branch_of(model, model.links[link_a].joint),
                          branch_of(model, model.links[link_b].joint)};
  while (!joints.of_a.empty() && !joints.of_b.empty() && joints.of_a.back() == joints.of_b.back()) {
    joints.of_a.pop_back();
    joints.of_b.pop_back();
  }
  return joints;
}

std::optional<std::size_t> joint_of_neighbours(const Model& model, std::size_t a, std::size_t b) {
  const JointsBetween joints = joints_between(model, a, b);
  if (joints.of_a.size() + joints.of_b.size() != 1) {
    return std::nullopt;
  }
  return joints.of_a.empty() ? joints.of_b[0] : joints.of_a[0];
}

bool is_between_neighbours(const Model& model, std::size_t joint) {
  return std::any_of(model.neighbours.begin(), model.neighbours.end(), [&](const auto& pair) {
    return joint_of_neighbours(model, pair.first, pair.second) == joint;
  });
}

std::vector<Transform> frames_inwards(const Model& model, const std::vector<std::size_t>& joints,
                                      const std::vector<double>& variables) {
  std::vector<Transform> frames(joints.size());
  Transform parent;
  for (std::size_t i = joints.size(); i-- != 0;) {
    const ModelJoint& joint = model.joints[joints[i]];
    const Transform motion = motion_of(joint, coordinate_of(joint, variables));
    frames[i] = parent = composed(composed(parent, joint.fixed), motion);
  }
  return frames;
}

Transform frame_between(const Model& model, const JointsBetween& joints,
                        const std::vector<double>& variables) {
  const auto outermost = [&](const std::vector<std::size_t>& branch) {
    const std::vector<Transform> frames = frames_inwards(model, branch, variables);
    return frames.empty() ? Transform() : frames.front();
  };
  return composed(inverse(outermost(joints.of_a)), outermost(joints.of_b));
}

Frame fixed_frame(const Transform& transform, double cell) {
  Frame frame{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      frame.rotation[i][j] =
          static_cast<std::int32_t>(std::lround(transform.rotation[i][j] * kRotationOne));
    }
    frame.translation[i] =
        static_cast<std::int32_t>(std::lround(transform.translation[i] / cell * kFrameCell));
  }
  return frame;
}

Transform transform_of(const Frame& frame, double cell) {
  Transform transform;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      transform.rotation[i][j] = static_cast<double>(frame.rotation[i][j]) / kRotationOne;
    }
    transform.translation[i] = frame.translation[i] * cell / kFrameCell;
  }
  return transform;
}

Pose pose_of(const Transform& transform, double cell) {
  return lattice_pose(transform, cell, "the robot");
}

}  // namespace flashbvh::tool
