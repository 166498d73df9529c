#include "robot/baked/robot_c_writer.hpp"

#include <cstddef>
#include <stdexcept>

#include "bake/image_bytes.hpp"
#include "flashbvh/image.hpp"
#include "robot/baked/robot_text.hpp"
#include "robot/baked/robot_writer.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr const char* kWrittenForC =
    "/* Written by `flashbvh robot`; run it again instead of changing this. */\n";

/// Where a part of the image lies: "name + words", or null for none.
std::string place_of(const void* part, const std::vector<std::uint32_t>& image,
                     const std::string& name) {
  if (part == nullptr) {
    return kRobotInC.null;
  }
  const std::ptrdiff_t bytes =
      static_cast<const char*>(part) - reinterpret_cast<const char*>(image.data());
  if (bytes % 4 != 0) {
    throw std::logic_error("a part of an image that does not start with a word");
  }
  return concat(name, " + ", bytes / 4);
}

/// A flashbvh_mesh_view of the image.
std::string view_of(const std::vector<std::uint32_t>& image, const std::string& name) {
  Mesh m;
  if (open_image(image.data(), image.size() * sizeof image[0], m) != Status::done) {
    throw std::logic_error("an image that does not open");
  }
  const auto place = [&](const void* part) { return place_of(part, image, name); };
  return concat("{", place(m.nodes), ", ", m.node_count, ", ", m.leaf_count, ", ", m.stack_need,
                ",\n     ", place(m.triangles), ", ", place(m.triangle_ids), ", ",
                place(m.leaf_offsets), ", ", place(m.vertices), ", ", place(m.shell_vertices),
                ",\n     ", m.triangle_count, ", ", m.vertex_count, ", ", m.shell_count, ", ",
                m.longest_edge, ", {", m.origin[0], ", ", m.origin[1], ", ", m.origin[2], "}, ",
                static_cast<int>(m.unit), ", ", m.is_closed ? "true" : "false", ", ",
                hex(m.cell_bits, 16), "}");
}

std::string c_meshes_of(const std::vector<BakedLink>& links, const std::vector<OutputName>& names) {
  std::string text;
  std::string views = "static const flashbvh_mesh_view meshes[] = {\n";
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::vector<std::uint32_t> image = bake::image_of(links[i].tree);
    const std::string name = concat("mesh_", i);
    text += concat("/* ", names[i].word, " */\nstatic ",
                   array(concat("uint32_t ", name, "[]"), image,
                         [](std::uint32_t word) { return hex(word, 8); }),
                   "\n");
    views += "    " + view_of(image, name) + ",\n";
  }
  return text + views + "};\n\n";
}

std::size_t flash_bytes_in_c(const FixedRobot& robot, const std::vector<BakedLink>& links) {
  constexpr std::size_t kViewBytes = 64;  // with pointers of four bytes
  std::size_t bytes = robot_array_bytes(robot);
  for (const BakedLink& link : links) {
    bytes += kViewBytes + 4 * bake::image_of(link.tree).size();
  }
  return bytes;
}

std::string enumerator(const std::string& name, std::size_t value, const char* comment) {
  return concat("  ", name, " = ", value, ", /* ", comment, " */\n");
}

/// "PREFIXelbow = 2," for each; nothing if there are none.
std::string c_numbers_of(const std::string& prefix, const char* comment,
                         const std::vector<std::string>& names) {
  const std::vector<OutputName> distinct = distinct_names(names);
  std::string text;
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    text += concat("  ", prefix, distinct[i].word, " = ", i, ",\n");
  }
  return names.empty() ? "" : concat("/** ", comment, " */\nenum {\n", text, "};\n\n");
}

std::string mount_names(const Model& model, double cell, const OutputName& name, bool is_declared) {
  const std::vector<OutputName> distinct = distinct_names(names_of_mounts(model));
  std::string text;
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    text += concat(is_declared ? "extern " : "", "const flashbvh_mount ", name.word, "_mount_",
                   distinct[i].word);
    text += is_declared
                ? ";\n"
                : concat(" = ", text_of(fixed_mount(model.mounts[i], cell), kRobotInC), ";\n");
  }
  return text;
}

std::string c_constants_of(const FixedRobot& robot, const std::vector<BakedLink>& links,
                           const std::string& word) {
  const double cell = links[0].tree.cell;
  return "enum {\n" + enumerator(word + "_LINK_COUNT", robot.links().size(), "bodies with a mesh") +
         enumerator(word + "_JOINT_COUNT", robot.joints().size(), "that move, mimics among them") +
         enumerator(word + "_VARIABLE_COUNT", robot.robot().variable_count,
                    "joints that are no mimics") +
         enumerator(word + "_PAIR_COUNT", robot.pairs().size(), "of links that can collide") +
         enumerator(word + "_PAIR_JOINT_COUNT", robot.pair_joint_count(),
                    "between the links of all pairs") +
         enumerator(word + "_REACH_COUNT", robot.reaches().size(), "for a workcell's room") +
         enumerator(word + "_FLASH_BYTES", flash_bytes_in_c(robot, links), "on a 32-bit core") +
         concat("};\n#define ", word, "_CELL ", floating_literal(cell), " /* in m */\n#define ",
                word, "_CELLS_PER_UNIT ", cells_per_unit_literal(cell), " /* cells in 1 m */\n\n");
}

/// What a guard and a motion need in RAM.
std::string state_sizes(const std::string& word) {
  return concat("/** Bytes of a guard's state, and of a motion's. */\n#define ", word,
                "_GUARD_STATE_SIZE \\\n  FLASHBVH_GUARD_STATE_SIZE(", word, "_JOINT_COUNT, ", word,
                "_PAIR_COUNT, ", word, "_PAIR_JOINT_COUNT)\n#define ", word,
                "_MOTION_STATE_SIZE \\\n  FLASHBVH_MOTION_STATE_SIZE(", word, "_VARIABLE_COUNT, ",
                word, "_JOINT_COUNT)\n\n");
}

std::string unguarded_declared(const Model& model, const std::vector<UnguardedPair>& unguarded,
                               const std::string& word) {
  const std::vector<OutputName> links = distinct_names(names_of_links(model));
  std::string text = concat("\n/** ", kUnguardedComment);
  for (const UnguardedPair& pair : unguarded) {
    text += concat("\n * ", links[pair.a].word, " - ", links[pair.b].word);
  }
  text += concat(" */\nenum { ", word, "_UNGUARDED_COUNT = ", unguarded.size(), " };\n");
  return unguarded.empty() ? text
                           : text + concat("extern const flashbvh_robot_unguarded ", word,
                                           "_unguarded_pairs[", word, "_UNGUARDED_COUNT];\n");
}

std::string unguarded_defined(const Model& model, const std::vector<UnguardedPair>& unguarded,
                              const std::string& word) {
  if (unguarded.empty()) {
    return "";
  }
  std::vector<std::string> links;
  for (const OutputName& link : distinct_names(names_of_links(model))) {
    links.push_back(word + "_link_" + link.word);
  }
  return array(concat("flashbvh_robot_unguarded ", word, "_unguarded_pairs[]"), unguarded,
               [&](const UnguardedPair& pair) { return text_of(pair, links, kRobotInC); });
}

std::string c_header_of(const Model& model, const FixedRobot& robot,
                        const std::vector<BakedLink>& links,
                        const std::vector<UnguardedPair>& unguarded, const OutputName& name) {
  const std::string guard = "FLASHBVH_BAKED_" + name.word + "_ROBOT_H";
  return kWrittenForC +
         concat("#ifndef ", guard, "\n#define ", guard, "\n\n#include \"flashbvh/robot.h\"\n\n",
                version_guard(name), "\n") +
         c_constants_of(robot, links, name.word) + state_sizes(name.word) +
         c_numbers_of(name.word + "_variable_",
                      "Where each joint's value stands among the caller's.",
                      names_of_variables(model)) +
         c_numbers_of(name.word + "_link_", "Links by number.", names_of_links(model)) +
         "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n"
         "/* Where tools are fastened: the frames of all links of the URDF. */\n" +
         mount_names(model, links[0].tree.cell, name, true) +
         unguarded_declared(model, unguarded, name.word) +
         concat("\nextern const flashbvh_robot ", name.word,
                "_robot;\n\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
}

std::string c_source_of(const Model& model, const FixedRobot& robot,
                        const std::vector<BakedLink>& links,
                        const std::vector<UnguardedPair>& unguarded, const OutputName& name) {
  const auto constants = [](const char* declaration, const auto& elements) {
    return array_if_any("static ", declaration, elements, kRobotInC);
  };
  return kWrittenForC + concat("#include \"", name.stem, ".robot.h\"\n\n") +
         c_meshes_of(links, distinct_names(names_of_links(model))) +
         constants("flashbvh_robot_joint joints", robot.joints()) +
         constants("flashbvh_robot_link links", robot.links()) +
         constants("flashbvh_robot_pair pairs", robot.pairs()) +
         constants("uint32_t reaches", robot.reaches()) +
         constants("uint8_t distance_tables", robot.distance_tables()) +
         mount_names(model, links[0].tree.cell, name, false) +
         unguarded_defined(model, unguarded, name.word) +
         concat("\nconst flashbvh_robot ", name.word, "_robot = ",
                text_of(robot,
                        {"joints", "links", "(const flashbvh_mesh*)meshes", "pairs", "reaches",
                         "distance_tables"},
                        kRobotInC),
                ";\n");
}

}  // namespace

SourceFiles robot_in_c(const Model& model, const FixedRobot& robot,
                       const std::vector<BakedLink>& links,
                       const std::vector<UnguardedPair>& unguarded, const OutputName& name) {
  return {c_header_of(model, robot, links, unguarded, name),
          c_source_of(model, robot, links, unguarded, name)};
}

}  // namespace flashbvh::tool
