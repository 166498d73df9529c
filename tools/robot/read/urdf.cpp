#include "robot/read/urdf.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/mesh_builder.hpp"
#include "robot/kinematics.hpp"
#include "robot/read/urdf_document.hpp"
#include "robot/read/xml_file.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

// Converts a URDF's joints to a Model's: removes fixed ones, rotates axes to z, and replaces the
// joint of a mimic by a variable.

/// A coordinate as multiplier * (coordinate of `joint`) + offset.
struct Follows {
  const UrdfJoint* joint;
  double multiplier;
  double offset;
};

template <class Joints>
auto find_joint(Joints& joints, const std::string& name) {
  return std::find_if(joints.begin(), joints.end(),
                      [&](const auto& joint) { return joint.name == name; });
}

/// Follows a mimic's chain to its end, a joint that is no mimic.
Follows follow(const UrdfRobot& robot, const UrdfJoint& mimic, const std::string& path) {
  Follows found = {&mimic, 1, 0};
  for (std::size_t steps = 0; found.joint->mimic; ++steps) {
    const UrdfMimic& of = *found.joint->mimic;
    const std::string place = at_element(path, "joint", found.joint->name);
    const auto next = find_joint(robot.joints, of.joint);
    if (next == robot.joints.end()) {
      throw UserError(place, "mimics ", tool::quoted(of.joint),
                      ", which is no joint of the robot; name one that is");
    }
    if (next->type == UrdfJoint::Type::fixed) {
      throw UserError(place, "mimics ", tool::quoted(of.joint),
                      ", which is fixed; make it fixed, too");
    }
    if (steps == robot.joints.size()) {
      throw UserError(place, "mimics itself by way of others; leave out one <mimic> of the circle");
    }
    found = {&*next, found.multiplier * of.multiplier, found.multiplier * of.offset + found.offset};
  }
  if (!is_coordinate(found.multiplier) || !is_coordinate(found.offset)) {
    throw UserError(at_element(path, "joint", mimic.name),
                    "has a <mimic> whose numbers are out of range; give smaller ones");
  }
  return found;
}

/// For a mimic of a continuous joint: it has to be continuous, with an integer multiplier.
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
  joint.lower = -kPi;
  joint.upper = kPi;
}

/// Sets the limits that follow from the variable's.
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

/// Few joints have such limits, in radians: the file may mean degrees.
constexpr double kManyTurns = 4 * kPi;

std::string in_radians(double degrees) {
  return significant(degrees * kPi / 180, 6);
}

/// Scales an axis to unit length. `place`: of the joint.
Vector3 unit_axis(const Vector3& axis, const std::string& place, Warnings& warnings) {
  const double length = length_of(axis);
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

/// Sets a model's joints, variables and mounts. UserError, naming the joint and the remedy, for
/// axes of length 0, and for limits out of order or of four turns or more. Also for mimics of
/// unknown joints, of each other, or of a continuous joint that they can't follow.
class TreeBuilder {
 public:
  /// `path`: for messages.
  TreeBuilder(const UrdfRobot& robot, const std::string& path, Model& model, Warnings& warnings)
      : robot_(robot), path_(path), model_(model), warnings_(warnings) {}

  void build() {
    std::vector<std::vector<const UrdfJoint*>> below(robot_.links.size());
    for (std::size_t i = robot_.joints.size(); i-- != 0;) {
      below[robot_.joints[i].parent].push_back(&robot_.joints[i]);  // in reverse, for a stack
    }
    for (const UrdfLink& link : robot_.links) {
      model_.mounts.push_back({link.name, kNoJoint, {}});
    }
    std::vector<const UrdfJoint*> open = below[robot_.root];
    while (!open.empty()) {
      const UrdfJoint& joint = *open.back();
      open.pop_back();
      place_child(joint, model_.mounts[joint.parent], model_.mounts[joint.child]);
      open.insert(open.end(), below[joint.child].begin(), below[joint.child].end());
    }
    for (ModelJoint& joint : model_.joints) {
      resolve_mimic(*find_joint(robot_.joints, joint.name), joint);
    }
  }

 private:
  void place_child(const UrdfJoint& joint, const ModelMount& parent, ModelMount& child) {
    child.joint = parent.joint;
    child.transform = composed(parent.transform, joint.origin);
    if (joint.type == UrdfJoint::Type::fixed) {
      return;
    }
    const std::string place = at_element(path_, "joint", joint.name);
    const Transform turned = rotation_to(unit_axis(joint.axis, place, warnings_));
    ModelJoint made;
    made.name = joint.name;
    made.parent = parent.joint;
    made.fixed = composed(child.transform, turned);
    made.type = joint.type == UrdfJoint::Type::prismatic    ? JointType::prismatic
                : joint.type == UrdfJoint::Type::continuous ? JointType::continuous
                                                            : JointType::revolute;
    child.joint = model_.joints.size();
    child.transform = inverse(turned);
    if (joint.mimic) {
      made.lower = joint.lower;  // resolve_mimic() warns of them and replaces them
      made.upper = joint.upper;
    } else {
      set_limits(joint, place, made, warnings_);
      made.variable = model_.variables.size();
      model_.variables.push_back(child.joint);
    }
    model_.joints.push_back(std::move(made));
  }

  /// Replaces the joint of a mimic by a variable. A mimic's limits follow from its variable's; its
  /// own are ignored, as is usual.
  void resolve_mimic(const UrdfJoint& mimic, ModelJoint& joint) {
    if (!mimic.mimic) {
      return;
    }
    const std::string place = at_element(path_, "joint", joint.name);
    const Follows follows = follow(robot_, mimic, path_);
    const ModelJoint& master = *find_joint(model_.joints, follows.joint->name);
    joint.variable = master.variable;
    joint.multiplier = follows.multiplier;
    joint.offset = follows.offset;
    if (master.type == JointType::continuous) {
      follow_continuous(joint, master.name, place);
    } else {
      follow_limited(joint, master, place, warnings_);
    }
  }

  const UrdfRobot& robot_;
  const std::string& path_;
  Model& model_;
  Warnings& warnings_;
};

bool are_neighbours(const Model& model, std::size_t a, std::size_t b) {
  const std::size_t joint_a = model.links[a].joint;
  const std::size_t joint_b = model.links[b].joint;
  const auto hangs_on = [&](std::size_t joint, std::size_t other) {
    return joint != kNoJoint && model.joints[joint].parent == other;
  };
  return joint_a == joint_b || hangs_on(joint_a, joint_b) || hangs_on(joint_b, joint_a);
}

constexpr const char* kSeenAlone =
    "has a <visual> but no <collision>: it collides with nothing; give it a <collision>, or let "
    "all "
    "such links collide by their visual shapes: --visual-too";

void add_links(const UrdfRobot& robot, const std::string& path, const Packages& packages,
               Model& model, Warnings& warnings) {
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const UrdfLink& link = robot.links[i];
    if (link.collisions.empty()) {
      if (link.has_visual) {
        warnings.add(at_element(path, "link", link.name), kSeenAlone);
      }
      continue;
    }
    model.links.emplace_back();
    model.links.back().name = link.name;
    model.links.back().joint = model.mounts[i].joint;
    add_link_mesh(link, model.mounts[i].transform, path, packages, model.links.back(), warnings);
  }
  if (model.links.empty()) {
    throw UserError(path, "has no link with a <collision>; give those that can collide one");
  }
}

}  // namespace

Model read_urdf(const std::string& path, const Packages& packages, const std::string& srdf,
                Warnings& warnings, bool visual_too) {
  check_no_mesh(path);
  const UrdfRobot robot = read_urdf_document(path, visual_too, warnings);
  Model model;
  model.name = robot.name;
  model.path = path;
  TreeBuilder(robot, path, model, warnings).build();
  add_links(robot, path, packages, model, warnings);
  for (std::size_t a = 0; a < model.links.size(); ++a) {
    for (std::size_t b = a + 1; b < model.links.size(); ++b) {
      if (are_neighbours(model, a, b)) {
        model.neighbours.emplace_back(a, b);
      }
    }
  }
  for (const UrdfJoint& joint : robot.joints) {
    const std::size_t parent = find_link(model, robot.links[joint.parent].name);
    const std::size_t child = find_link(model, robot.links[joint.child].name);
    if (parent != kNoLink && child != kNoLink) {
      model.adjacent.emplace_back(std::minmax(parent, child));
    }
  }
  if (!srdf.empty()) {
    model.disabled = read_srdf(srdf, model, warnings);
  }
  return model;
}

}  // namespace flashbvh::tool
