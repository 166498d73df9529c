#include "robot/baked/robot_writer.hpp"

#include "flashbvh/robot/guard.hpp"
#include "image/cpp_writer.hpp"
#include "robot/baked/robot_text.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr const char* kWrittenBy =
    "// Written by `flashbvh robot`; run it again instead of changing this.\n";

std::string mounts_of(const Model& model, double cell) {
  const std::vector<OutputName> distinct = distinct_names(names_of_mounts(model));
  std::string text =
      "\n/// Where tools are fastened: the frames of all links of the URDF.\nnamespace mounts {\n";
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    text += concat("constexpr flashbvh::Mount ", distinct[i].identifier, " = ",
                   text_of(fixed_mount(model.mounts[i], cell), kRobotInCpp), ";\n");
  }
  return text + "}  // namespace mounts\n";
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

/// As C++ reads it back, whatever bytes it holds.
std::string literal(const std::string& text) {
  std::string written = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte >= ' ' && byte < 0x7F && c != '"' && c != '\\' && c != '?';
    const char octal[] = {'\\', static_cast<char>('0' + byte / 64),
                          static_cast<char>('0' + byte / 8 % 8), static_cast<char>('0' + byte % 8)};
    written += is_plain ? std::string(1, c) : std::string(octal, 4);
  }
  return written + "\"";
}

std::string array_of_names(const char* array, const std::vector<std::string>& names) {
  std::string text = concat("constexpr const char* ", array, "[] = {");
  for (const std::string& name : names) {
    text += concat(&name == &names[0] ? "" : ", ", literal(name));
  }
  return text + "};\n";
}

std::string constant(const char* name, std::size_t value, const char* comment) {
  return concat("constexpr uint32_t ", name, " = ", value, ";  ///< ", comment, "\n");
}

std::string unguarded_of(const Model& model, const std::vector<UnguardedPair>& unguarded) {
  std::string text = concat("\n/// ", kUnguardedComment, "\n") +
                     concat("constexpr uint32_t kUnguardedCount = ", unguarded.size(), ";\n");
  if (unguarded.empty()) {
    return text;
  }
  std::vector<std::string> links;
  for (const OutputName& name : distinct_names(names_of_links(model))) {
    links.push_back("links::" + name.identifier);
  }
  return text + array("flashbvh::RobotUnguarded kUnguardedPairs[]", unguarded,
                      [&](const UnguardedPair& pair) { return text_of(pair, links, kRobotInCpp); });
}

std::string header_of(const Model& model, const FixedRobot& robot,
                      const std::vector<BakedLink>& links,
                      const std::vector<UnguardedPair>& unguarded, const OutputName& name) {
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
         unguarded_of(model, unguarded) + mounts_of(model, cell) +
         "\n/// For messages: linked only if they are used.\n" +
         array_of_names("kLinkNames", names_of_links(model)) +
         (model.variables.empty() ? ""
                                  : array_of_names("kVariableNames", names_of_variables(model))) +
         concat(
             "\nextern const flashbvh::Robot robot;\n\n/// What a flashbvh::Guard of it needs in "
             "RAM.\nusing GuardState = flashbvh::GuardStateOf<",
             at_least_one(robot.joints().size()), ", ", at_least_one(robot.pairs().size()), ", ",
             at_least_one(robot.pair_joint_count()), ">;\n\n}  // namespace ", name.identifier,
             "\n\n#endif\n");
}

std::string meshes_of(const std::vector<BakedLink>& links, const std::vector<OutputName>& names) {
  std::string text;
  std::string views = "const flashbvh::Mesh kMeshes[] = {\n";
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
  const auto constants = [](const char* declaration, const auto& elements) {
    return array_if_any("", declaration, elements, kRobotInCpp);
  };
  return kWrittenBy +
         concat("#include \"", name.stem, ".robot.hpp\"\n\nnamespace ", name.identifier,
                " {\nnamespace {\n\n") +
         meshes_of(links, distinct_names(names_of_links(model))) +
         constants("flashbvh::RobotJoint kJoints", robot.joints()) +
         constants("flashbvh::RobotLink kLinks", robot.links()) +
         constants("flashbvh::RobotPair kPairs", robot.pairs()) +
         constants("uint32_t kReaches", robot.reaches()) +
         constants("uint8_t kCharts", robot.distance_tables()) +
         concat("}  // namespace\n\nconst flashbvh::Robot robot = ",
                text_of(robot, {"kJoints", "kLinks", "kMeshes", "kPairs", "kReaches", "kCharts"},
                        kRobotInCpp),
                ";\n\n}  // namespace ", name.identifier, "\n");
}

}  // namespace

std::size_t robot_array_bytes(const FixedRobot& robot) {
  constexpr std::size_t kRobotBytes = 56;  // with pointers of four bytes
  return kRobotBytes + robot.joints().size() * sizeof(RobotJoint) +
         robot.links().size() * sizeof(RobotLink) + robot.pairs().size() * sizeof(RobotPair) +
         robot.reaches().size() * 4 + robot.distance_tables().size();
}

std::size_t robot_flash_bytes(const FixedRobot& robot, const std::vector<BakedLink>& links) {
  std::size_t bytes = robot_array_bytes(robot);
  for (const BakedLink& link : links) {
    bytes += flash_bytes(link.tree);
  }
  return bytes;
}

std::size_t robot_ram_bytes(const Robot& robot, std::size_t pair_joint_count) {
  return sizeof(GuardCore) +
         at_least_one(robot.joint_count) * (4 * sizeof(JointCoordinate) + sizeof(Frame)) +
         at_least_one(robot.pair_count) * sizeof(GuardPair) +
         at_least_one(pair_joint_count) * sizeof(JointCoordinate);
}

SourceFiles robot_sources(const Model& model, const FixedRobot& robot,
                          const std::vector<BakedLink>& links,
                          const std::vector<UnguardedPair>& unguarded, const OutputName& name) {
  return {header_of(model, robot, links, unguarded, name), source_of(model, robot, links, name)};
}

}  // namespace flashbvh::tool
