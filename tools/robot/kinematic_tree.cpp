#include "robot/kinematic_tree.hpp"

#include <cmath>

#include "robot/joint_axis.hpp"
#include "robot/mimics.hpp"
#include "robot/xml_file.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Of a joint that few machines have, in radians: who writes as much may mean degrees.
constexpr double kManyTurns = 4 * kPi;

std::string in_radians(double degrees) {
  return significant(degrees * kPi / 180, 6);
}

/// To unit length. `place`: of the joint.
Vector3 unit_axis(const Vector3& axis, const std::string& place, Warnings& warnings) {
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  if (!(length > 1e-6 && length < 1e6)) {
    throw UserError(place, "moves along an axis of length ", significant(length, 3),
                    ", which has no direction; give its <axis> as in xyz=\"0 0 1\"");
  }
  if (std::fabs(length - 1) > 0.01) {
    warnings.add(place, concat("has an axis of length ", significant(length, 3), "; taken as 1"));
  }
  return length == 1 ? axis : Vector3{axis[0] / length, axis[1] / length, axis[2] / length};
}

void set_limits(const UrdfJoint& joint, const std::string& place, ModelJoint& made,
                Warnings& warnings) {
  if (joint.lower > joint.upper) {
    throw UserError(place, "has a lower limit of ", shortest(joint.lower), " above its upper of ",
                    shortest(joint.upper), "; exchange them");
  }
  if (made.type == JointType::continuous) {
    if (joint.lower != 0 || joint.upper != 0) {
      warnings.add(place,
                   concat("is continuous, so its limits of ", shortest(joint.lower), " and ",
                          shortest(joint.upper), " do not count; make it revolute if they should"));
    }
    made.lower = -kPi;
    made.upper = kPi;
    return;
  }
  if (made.type == JointType::revolute && (joint.lower <= -kMaxAngle || joint.upper >= kMaxAngle)) {
    throw UserError(place, "has limits of four turns or more, ", shortest(joint.lower), " to ",
                    shortest(joint.upper), " rad; if these are degrees, write ",
                    in_radians(joint.lower), " and ", in_radians(joint.upper),
                    "; if it turns without end, make it continuous");
  }
  if (made.type == JointType::revolute && std::max(-joint.lower, joint.upper) > kManyTurns) {
    warnings.add(place, concat("turns from ", shortest(joint.lower), " to ", shortest(joint.upper),
                               " rad, over two turns one way; if these are degrees, write ",
                               in_radians(joint.lower), " and ", in_radians(joint.upper)));
  }
  made.lower = joint.lower;
  made.upper = joint.upper;
}

class TreeBuilder {
 public:
  TreeBuilder(const UrdfRobot& robot, const std::string& path, Warnings& warnings)
      : robot_(robot), path_(path), warnings_(warnings), below_(robot.links.size()) {
    for (std::size_t i = robot.joints.size(); i-- != 0;) {
      below_[robot.joints[i].parent].push_back(i);  // the last first, as a stack takes them
    }
  }

  KinematicTree build() {
    tree_.links.resize(robot_.links.size());
    std::vector<std::size_t> open = below_[robot_.root];
    while (!open.empty()) {
      const UrdfJoint& joint = robot_.joints[open.back()];
      const std::size_t number = open.back();
      open.pop_back();
      tree_.links[joint.child] = place_child(joint, number);
      open.insert(open.end(), below_[joint.child].begin(), below_[joint.child].end());
    }
    resolve_mimics(robot_, urdf_joints_, path_, tree_.joints, tree_.variables, warnings_);
    return std::move(tree_);
  }

 private:
  KinematicTree::Place place_child(const UrdfJoint& joint, std::size_t number) {
    const KinematicTree::Place& parent = tree_.links[joint.parent];
    const Transform origin = composed(parent.transform, joint.origin);
    if (joint.type == UrdfJoint::Type::fixed) {
      return {parent.joint, origin};
    }
    const std::string place = at_element(path_, "joint", joint.name);
    const Transform turned = rotation_to(unit_axis(joint.axis, place, warnings_));
    ModelJoint made;
    made.name = joint.name;
    made.parent = parent.joint;
    made.fixed = composed(origin, turned);
    made.type = joint.type == UrdfJoint::Type::prismatic    ? JointType::prismatic
                : joint.type == UrdfJoint::Type::continuous ? JointType::continuous
                                                            : JointType::revolute;
    set_limits(joint, place, made, warnings_);
    tree_.joints.push_back(std::move(made));
    urdf_joints_.push_back(number);
    return {tree_.joints.size() - 1, inverse(turned)};
  }

  const UrdfRobot& robot_;
  const std::string& path_;
  Warnings& warnings_;
  std::vector<std::vector<std::size_t>> below_;  ///< of each link, its joints
  std::vector<std::size_t> urdf_joints_;
  KinematicTree tree_;
};

}  // namespace

KinematicTree kinematic_tree(const UrdfRobot& robot, const std::string& path, Warnings& warnings) {
  return TreeBuilder(robot, path, warnings).build();
}

}  // namespace flashbvh::tool
