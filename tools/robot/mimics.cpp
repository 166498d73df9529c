#include "robot/mimics.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/mesh_builder.hpp"
#include "robot/joint_axis.hpp"
#include "robot/xml_file.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// A coordinate as multiplier * (that of `joint`) + offset.
struct Follows {
  std::size_t joint;  ///< of the URDF
  double multiplier;
  double offset;
};

/// Of a mimic: the joint at the chain's end, which is none.
Follows follow(const UrdfRobot& robot, const std::map<std::string, std::size_t>& numbers,
               std::size_t mimic, const std::string& path) {
  Follows found = {mimic, 1, 0};
  for (std::size_t steps = 0; robot.joints[found.joint].mimic; ++steps) {
    const UrdfJoint& joint = robot.joints[found.joint];
    const std::string place = at_element(path, "joint", joint.name);
    const auto next = numbers.find(joint.mimic->joint);
    if (next == numbers.end()) {
      throw UserError(place, "mimics ", tool::quoted(joint.mimic->joint),
                      ", which is no joint of the robot; name one that is");
    }
    if (robot.joints[next->second].type == UrdfJoint::Type::fixed) {
      throw UserError(place, "mimics ", tool::quoted(joint.mimic->joint),
                      ", which is fixed; make it fixed, too");
    }
    if (steps == robot.joints.size()) {
      throw UserError(place, "mimics itself by way of others; leave out one <mimic> of the circle");
    }
    found = {next->second, found.multiplier * joint.mimic->multiplier,
             found.multiplier * joint.mimic->offset + found.offset};
  }
  if (!is_coordinate(found.multiplier) || !is_coordinate(found.offset)) {
    throw UserError(at_element(path, "joint", robot.joints[mimic].name),
                    "has a <mimic> whose numbers are out of range; give smaller ones");
  }
  return found;
}

/// A mimic of a joint without ends: it turns on, too, and a whole number of times.
void follow_continuous(ModelJoint& joint, const std::string& master, const std::string& place) {
  if (joint.type == JointType::prismatic) {
    throw UserError(place, "slides with ", tool::quoted(master),
                    ", which turns without end; make that revolute, with limits");
  }
  if (std::nearbyint(joint.multiplier) != joint.multiplier) {
    throw UserError(place, "mimics ", tool::quoted(master),
                    ", which is continuous, by a multiplier of ", shortest(joint.multiplier),
                    ": after a turn it would stand elsewhere; make that joint revolute, with "
                    "limits");
  }
  joint.type = JointType::continuous;
}

/// What the variable's limits give.
void follow_limited(ModelJoint& joint, const ModelJoint& master, const std::string& place,
                    Warnings& warnings) {
  const double one = joint.multiplier * master.lower + joint.offset;
  const double other = joint.multiplier * master.upper + joint.offset;
  const double lower = std::min(one, other);
  const double upper = std::max(one, other);
  const bool is_continuous = joint.type == JointType::continuous;
  const double tolerance = 1e-9 * std::max(std::fabs(lower), std::fabs(upper));
  if (!is_continuous && (lower < joint.lower - tolerance || upper > joint.upper + tolerance)) {
    warnings.add(place, concat("mimics ", tool::quoted(master.name), ", which takes it from ",
                               shortest(lower), " to ", shortest(upper),
                               ", past its own limits; they do not count"));
  }
  joint.lower = lower;
  joint.upper = upper;
  joint.type = is_continuous ? JointType::revolute : joint.type;
  if (joint.type == JointType::revolute && (lower <= -kMaxAngle || upper >= kMaxAngle)) {
    throw UserError(place, "is turned four times or more by ", tool::quoted(master.name),
                    "; give that narrower limits");
  }
}

}  // namespace

void resolve_mimics(const UrdfRobot& robot, const std::vector<std::size_t>& urdf_joints,
                    const std::string& path, std::vector<ModelJoint>& joints,
                    std::vector<std::size_t>& variables, Warnings& warnings) {
  std::map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    numbers[robot.joints[i].name] = i;
  }
  std::map<std::size_t, std::size_t> made_of;  // by number in the URDF
  for (std::size_t i = 0; i < joints.size(); ++i) {
    made_of[urdf_joints[i]] = i;
    if (!robot.joints[urdf_joints[i]].mimic) {
      joints[i].variable = variables.size();
      variables.push_back(i);
    }
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!robot.joints[urdf_joints[i]].mimic) {
      continue;
    }
    const std::string place = at_element(path, "joint", joints[i].name);
    const Follows follows = follow(robot, numbers, urdf_joints[i], path);
    const ModelJoint& master = joints[made_of.at(follows.joint)];
    joints[i].variable = master.variable;
    joints[i].multiplier = follows.multiplier;
    joints[i].offset = follows.offset;
    if (master.type == JointType::continuous) {
      follow_continuous(joints[i], master.name, place);
    } else {
      follow_limited(joints[i], master, place, warnings);
    }
  }
}

}  // namespace flashbvh::tool
