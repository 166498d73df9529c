#include "robot/baked/robot_text.hpp"

#include "text/numbers.hpp"

namespace flashbvh::tool {

const RobotLanguage kRobotInCpp = {
    "flashbvh::kBase",
    {"flashbvh::JointType::revolute", "flashbvh::JointType::continuous",
     "flashbvh::JointType::prismatic"},
    {"flashbvh::WhyUnguarded::intersecting", "flashbvh::WhyUnguarded::believed"},
    "{}",
    "nullptr"};
const RobotLanguage kRobotInC = {
    "FLASHBVH_BASE",
    {"FLASHBVH_JOINT_REVOLUTE", "FLASHBVH_JOINT_CONTINUOUS", "FLASHBVH_JOINT_PRISMATIC"},
    {"FLASHBVH_UNGUARDED_INTERSECTING", "FLASHBVH_UNGUARDED_BELIEVED"},
    "{0}",
    "0"};

namespace {

std::string text_of(const Frame& frame) {
  std::string text = "{{";
  for (const auto& row : frame.rotation) {
    text += concat("{", row[0], ", ", row[1], ", ", row[2], "}",
                   &row == &frame.rotation[2] ? "" : ", ");
  }
  return text + concat("}, {", frame.translation[0], ", ", frame.translation[1], ", ",
                       frame.translation[2], "}}");
}

/// kBase has a name.
std::string joint_number(std::uint8_t joint, const RobotLanguage& language) {
  return joint == kBase ? language.base : std::to_string(joint);
}

template <class Element>
const char* name_if_any(const char* name, const std::vector<Element>& elements,
                        const RobotLanguage& language) {
  return elements.empty() ? language.null : name;
}

}  // namespace

std::string text_of(const Mount& mount, const RobotLanguage& language) {
  return concat("{", joint_number(mount.joint, language), ", ", text_of(mount.frame), "}");
}

std::string text_of(const RobotJoint& joint, const RobotLanguage& language) {
  return concat("{", text_of(joint.fixed), ",\n     ", joint.lower, ", ", joint.upper, ", ",
                joint.multiplier, ", ", joint.offset, ", ", joint.shift, ", ",
                joint_number(joint.parent, language), ", ", joint.variable, ", ",
                language.joint_types[static_cast<std::size_t>(joint.type)], ", 0}");
}

std::string text_of(const RobotLink& link, const RobotLanguage& language) {
  return concat("{{", link.centre[0], ", ", link.centre[1], ", ", link.centre[2], "}, ",
                link.radius, "u, ", link.first_reach, ", ", joint_number(link.joint, language),
                ", ", language.zeros, "}");
}

std::string text_of(const RobotPair& pair, const RobotLanguage& /*language*/) {
  return concat("{", pair.stop, "u, ", pair.warn, "u, ", pair.reach, "u, ", pair.a, ", ", pair.b,
                ", ", pair.joints_a, ", ", pair.joints_b, "}");
}

std::string text_of(std::uint32_t reach, const RobotLanguage& /*language*/) {
  return concat(reach, "u");
}

std::string text_of(std::uint8_t distance, const RobotLanguage& /*language*/) {
  return std::to_string(distance);
}

std::string text_of(const UnguardedPair& pair, const std::vector<std::string>& links,
                    const RobotLanguage& language) {
  return concat("{", links[pair.a], ", ", links[pair.b], ", ",
                language.why_unguarded[static_cast<std::size_t>(pair.why)], ", 0}");
}

std::string text_of(const FixedRobot& robot, const RobotArrays& arrays,
                    const RobotLanguage& language) {
  const Robot& view = robot.robot();
  return concat("{\n    ", name_if_any(arrays.joints, robot.joints(), language), ", ", arrays.links,
                ", ", arrays.meshes, ", ", name_if_any(arrays.pairs, robot.pairs(), language), ", ",
                name_if_any(arrays.reaches, robot.reaches(), language), ", ",
                name_if_any(arrays.distance_tables, robot.distance_tables(), language), ",\n    ",
                robot.joints().size(), ", ", robot.links().size(), ", ", view.variable_count,
                ", 0, ", robot.pairs().size(), ", ", robot.reaches().size(), ",\n    ", view.slack,
                "u, ", view.distance_table_bytes, "u, ", hex(view.hash, 8), ", ",
                hex(view.cell_bits, 16), "}");
}

std::vector<std::string> names_of_variables(const Model& model) {
  std::vector<std::string> names;
  names.reserve(model.variables.size());
  for (const std::size_t joint : model.variables) {
    names.push_back(model.joints[joint].name);
  }
  return names;
}

std::vector<std::string> names_of_links(const Model& model) {
  std::vector<std::string> names;
  names.reserve(model.links.size());
  for (const ModelLink& link : model.links) {
    names.push_back(link.name);
  }
  return names;
}

std::vector<std::string> names_of_mounts(const Model& model) {
  std::vector<std::string> names;
  names.reserve(model.mounts.size());
  for (const ModelMount& mount : model.mounts) {
    names.push_back(mount.name);
  }
  return names;
}

}  // namespace flashbvh::tool
