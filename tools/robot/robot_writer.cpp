#include "robot/robot_writer.hpp"

#include <algorithm>

#include "flashbvh/robot/guard.hpp"
#include "image/cpp_writer.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr const char* kWrittenBy =
    "// Written by `flashbvh robot`; run it again instead of changing this.\n";

std::string text_of(const Frame& frame) {
  std::string text = "{{";
  for (const auto& row : frame.rotation) {
    text += concat("{", row[0], ", ", row[1], ", ", row[2], "}",
                   &row == &frame.rotation[2] ? "" : ", ");
  }
  return text + concat("}, {", frame.translation[0], ", ", frame.translation[1], ", ",
                       frame.translation[2], "}}");
}

const char* name_of(JointType type) {
  return type == JointType::prismatic    ? "prismatic"
         : type == JointType::continuous ? "continuous"
                                         : "revolute";
}

/// kBase has a name.
std::string joint_number(std::uint8_t joint) {
  return joint == kBase ? "flashbvh::kBase" : std::to_string(joint);
}

std::string text_of(const RobotJoint& joint) {
  return concat("{", text_of(joint.fixed), ",\n     ", joint.lower, ", ", joint.upper, ", ",
                joint.multiplier, ", ", joint.offset, ", ", joint.shift, ", ",
                joint_number(joint.parent), ", ", joint.variable,
                ", flashbvh::JointType::", name_of(joint.type), ", 0}");
}

std::string text_of(const RobotLink& link) {
  return concat("{{", link.centre[0], ", ", link.centre[1], ", ", link.centre[2], "}, ",
                link.radius, "u, ", link.first_reach, ", ", joint_number(link.joint), ", {}}");
}

std::string text_of(const RobotPair& pair) {
  return concat("{", pair.stop, "u, ", pair.warn, "u, ", pair.reach, "u, ", pair.a, ", ", pair.b,
                ", ", pair.joints_a, ", ", pair.joints_b, "}");
}

/// Nothing if there are none: C++ has no arrays of no elements.
template <class Element, class TextOf>
std::string array_if_any(const std::string& declaration, const std::vector<Element>& elements,
                         const TextOf& text) {
  return elements.empty() ? "" : array(declaration, elements, text) + "\n";
}

template <class Element>
std::string name_if_any(const char* name, const std::vector<Element>& elements) {
  return elements.empty() ? "nullptr" : name;
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

/// "constexpr uint8_t elbow = 2;" for each, in a namespace of their own.
std::string numbers_of(const char* scope, const char* comment,
                       const std::vector<std::string>& names) {
  std::string text = concat("/// ", comment, "\nnamespace ", scope, " {\n");
  const std::vector<OutputName> distinct = distinct_names(names);
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    text += concat("constexpr uint8_t ", distinct[i].identifier, " = ", i, ";\n");
  }
  return text + concat("}  // namespace ", scope, "\n");
}

std::string constant(const char* name, std::size_t value, const char* comment) {
  return concat("constexpr uint32_t ", name, " = ", value, ";  ///< ", comment, "\n");
}

/// Arrays have elements.
std::size_t at_least_one(std::size_t count) {
  return std::max<std::size_t>(count, 1);
}

std::string header_of(const Model& model, const FixedRobot& robot,
                      const std::vector<BakedLink>& links, const OutputName& name) {
  const double cell = links[0].tree.cell;
  const std::string guard = "FLASHBVH_BAKED_" + name.identifier + "_ROBOT_HPP";
  return kWrittenBy +
         concat("#ifndef ", guard, "\n#define ", guard,
                "\n\n#include <stdint.h>\n\n#include \"flashbvh/robot/guard.hpp\"\n"
                "#include \"flashbvh/version.hpp\"\n\n",
                version_guard(name), "\nnamespace ", name.identifier, " {\n\n") +
         constant("kLinkCount", robot.links().size(), "bodies with a mesh") +
         constant("kJointCount", robot.joints().size(), "that move, mimics among them") +
         constant("kVariableCount", robot.robot().variable_count, "joints that are no mimics") +
         constant("kPairCount", robot.pairs().size(), "of links that can collide") +
         constant("kPairJointCount", robot.pair_joint_count(), "between the links of all pairs") +
         constant("kFlashBytes", robot_flash_bytes(robot, links),
                  "what `robot` links, on a 32-bit core") +
         concat("constexpr double kCell = ", floating_literal(cell), ";  ///< in m\n",
                "constexpr float kCellsPerUnit = ", cells_per_unit_literal(cell),
                ";  ///< cells in 1 m\n\n") +
         numbers_of("variables", "Where each joint's value stands among the caller's.",
                    names_of_variables(model)) +
         "\n" + numbers_of("links", "Links by number.", names_of_links(model)) +
         concat(
             "\nextern const flashbvh::Robot robot;\n\n/// What a flashbvh::Guard of it needs in "
             "RAM.\nusing GuardState = flashbvh::GuardStateOf<",
             at_least_one(robot.joints().size()), ", ", at_least_one(robot.pairs().size()), ", ",
             at_least_one(robot.pair_joint_count()), ">;\n\n}  // namespace ", name.identifier,
             "\n\n#endif\n");
}

std::string meshes_of(const std::vector<BakedLink>& links, const std::vector<OutputName>& names) {
  std::string text;
  std::string views = "const flashbvh::PostMesh kMeshes[] = {\n";
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::string scope = concat("mesh_", i);
    text += concat("namespace ", scope, " {  // ", names[i].word, "\n\n",
                   arrays_of_mesh(links[i].tree), "\n}  // namespace ", scope, "\n\n");
    views += concat("    ", view_of_mesh(links[i].tree, scope + "::"), ",\n");
  }
  return text + views + "};\n\n";
}

std::string source_of(const Model& model, const FixedRobot& robot,
                      const std::vector<BakedLink>& links, const OutputName& name) {
  const auto text = [](const auto& element) { return text_of(element); };
  return kWrittenBy +
         concat("#include \"", name.stem, ".robot.hpp\"\n\nnamespace ", name.identifier,
                " {\nnamespace {\n\n") +
         meshes_of(links, distinct_names(names_of_links(model))) +
         array_if_any("flashbvh::RobotJoint kJoints[]", robot.joints(), text) +
         array_if_any("flashbvh::RobotLink kLinks[]", robot.links(), text) +
         array_if_any("flashbvh::RobotPair kPairs[]", robot.pairs(), text) +
         array_if_any("uint32_t kReaches[]", robot.reaches(),
                      [](std::uint32_t reach) { return concat(reach, "u"); }) +
         concat("}  // namespace\n\nconst flashbvh::Robot robot = {\n    ",
                name_if_any("kJoints", robot.joints()), ", kLinks, kMeshes, ",
                name_if_any("kPairs", robot.pairs()), ", ",
                name_if_any("kReaches", robot.reaches()), ",\n    ", robot.joints().size(), ", ",
                robot.links().size(), ", ", robot.robot().variable_count, ", 0, ",
                robot.pairs().size(), ", ", robot.reaches().size(), ",\n    ", robot.robot().slack,
                "u, ", hex(robot.robot().hash, 8), ", ", hex(robot.robot().cell_bits, 16),
                "};\n\n}  // namespace ", name.identifier, "\n");
}

}  // namespace

std::size_t robot_flash_bytes(const FixedRobot& robot, const std::vector<BakedLink>& links) {
  constexpr std::size_t kRobotBytes = 48;  // with pointers of four bytes
  std::size_t bytes = kRobotBytes + robot.joints().size() * sizeof(RobotJoint) +
                      robot.links().size() * sizeof(RobotLink) +
                      robot.pairs().size() * sizeof(RobotPair) + robot.reaches().size() * 4;
  for (const BakedLink& link : links) {
    bytes += flash_bytes(link.tree);
  }
  return bytes;
}

std::size_t robot_ram_bytes(const FixedRobot& robot) {
  return sizeof(GuardCore) +
         at_least_one(robot.joints().size()) * (4 * sizeof(JointCoordinate) + sizeof(Frame)) +
         at_least_one(robot.pairs().size()) * sizeof(GuardPair) +
         at_least_one(robot.pair_joint_count()) * sizeof(JointCoordinate);
}

SourceFiles robot_sources(const Model& model, const FixedRobot& robot,
                          const std::vector<BakedLink>& links, const OutputName& name) {
  return {header_of(model, robot, links, name), source_of(model, robot, links, name)};
}

}  // namespace flashbvh::tool
