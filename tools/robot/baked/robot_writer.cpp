#include "robot/baked/robot_writer.hpp"

#include <algorithm>

#include "flashbvh/robot.h"
#include "robot/baked/robot_image.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

template <class Element>
std::vector<OutputName> names_of(const std::vector<Element>& elements) {
  std::vector<std::string> names;
  names.reserve(elements.size());
  for (const Element& element : elements) {
    names.push_back(element.name);
  }
  return distinct_names(names);
}

std::vector<ModelJoint> joints_of_variables(const Model& model) {
  std::vector<ModelJoint> joints;
  for (const std::size_t joint : model.variables) {
    joints.push_back(model.joints[joint]);
  }
  return joints;
}

/// An enumerator "PREFIXelbow" for each; nothing if there are none.
std::string numbers_of(const std::string& prefix, const char* comment,
                       const std::vector<OutputName>& names) {
  std::string text;
  for (const OutputName& name : names) {
    text += concat("  ", prefix, name.word, ",\n");
  }
  return names.empty() ? "" : concat("\n/** ", comment, " */\nenum {\n", text, "};\n");
}

/// The sizes of a guard's and a motion's state in RAM.
std::string state_sizes(const std::string& word) {
  return concat(
      "/** Bytes of a guard's state, and of a motion's, for flashbvh/robot.h. */\n#define ", word,
      "_GUARD_STATE_SIZE \\\n  FLASHBVH_GUARD_STATE_SIZE(", word, "_JOINT_COUNT, ", word,
      "_PAIR_COUNT, ", word, "_PAIR_JOINT_COUNT)\n#define ", word,
      "_MOTION_STATE_SIZE \\\n  FLASHBVH_MOTION_STATE_SIZE(", word, "_VARIABLE_COUNT, ", word,
      "_JOINT_COUNT)\n");
}

std::string unguarded_text(const Model& model, const std::vector<UnguardedPair>& unguarded) {
  std::string text =
      "\n/* Links that a joint moves and no guard looks at: their collisions are never detected.\n";
  const std::vector<OutputName> links = names_of(model.links);
  const std::vector<OutputName> joints = names_of(model.joints);
  for (const UnguardedPair& pair : unguarded) {
    text +=
        concat(" * ", links[pair.a].word, " - ", links[pair.b].word,
               pair.joint == kNoJoint ? ""
                                      : concat(" within ", significant(pair.radius, 4), " m about ",
                                               joints[pair.joint].word,
                                               pair.is_never_outside ? ", never outside zone" : ""),
               "\n");
  }
  return text + (unguarded.empty() ? " * There are none. */\n" : " */\n");
}

}  // namespace

std::size_t robot_ram_bytes(const Robot& robot) {
  return FLASHBVH_GUARD_STATE_SIZE(std::size_t{robot.joint_count},
                                   std::max<std::size_t>(robot.pair_count, 1),
                                   std::max<std::size_t>(pair_joint_count(robot), 1));
}

SourceFiles robot_in_c(const std::vector<std::uint32_t>& image, const Model& model,
                       const Robot& robot, const std::vector<UnguardedPair>& unguarded,
                       const OutputName& name) {
  const std::string& word = name.word;
  const std::string about =
      count_macros(word,
                   {{"LINK_COUNT", robot.link_count, "bodies with a mesh"},
                    {"JOINT_COUNT", robot.joint_count, "that move, mimics among them"},
                    {"VARIABLE_COUNT", robot.variable_count, "joints that are no mimics"},
                    {"PAIR_COUNT", robot.pair_count, "of links that can collide"},
                    {"PAIR_JOINT_COUNT", pair_joint_count(robot), "between the links of all pairs"},
                    {"REACH_COUNT", robot.reach_count, "for a workcell's room"},
                    {"UNGUARDED_COUNT", unguarded.size(), "of unguarded_pairs()"},
                    {"IMAGE_BYTES", 4 * image.size(), "of the array"}}) +
      cell_macros(word, cell_of(robot), "m") + state_sizes(word) +
      numbers_of(word + "_variable_", "Where each joint's value stands among the caller's.",
                 names_of(joints_of_variables(model))) +
      numbers_of(word + "_link_", "Links by number.", names_of(model.links)) +
      numbers_of(word + "_mount_", "Of mounts(): the frames of all links of the URDF.",
                 names_of(model.mounts)) +
      unguarded_text(model, unguarded);
  return image_in_c(image, name,
                    {"robot", ".robot", word + "_robot_image",
                     "view_robot_unchecked(), flashbvh_view_robot_unchecked()."},
                    about);
}

}  // namespace flashbvh::tool
