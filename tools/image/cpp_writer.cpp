#include "image/cpp_writer.hpp"

#include <cstddef>
#include <cstring>

#include "flashbvh/image.hpp"
#include "image/source_text.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

std::string text_of(std::uint16_t value) {
  return std::to_string(value);
}
std::string text_of(std::uint32_t value) {
  return concat(value, "u");
}
std::string text_of(const Vertex& v) {
  return concat("{", v.x, ", ", v.y, ", ", v.z, "}");
}
template <class Index>
std::string text_of(const Corners<Index>& c) {
  return "{{" + text_of(c.corner[0]) + ", " + text_of(c.corner[1]) + ", " + text_of(c.corner[2]) +
         "}}";
}
template <class Index>
std::string text_of(const Node<Index>& node) {
  return "{{" + hex(node.box.upper_xy, 8) + ", " + hex(node.box.lower_xy, 8) + ", " +
         hex(node.box.z, 8) + "}, " + text_of(node.link) + ", " + text_of(node.data) + "}";
}

template <class Element>
std::string array_of(const std::string& type, const char* name,
                     const std::vector<Element>& elements) {
  return array(type + " " + name + "[]", elements,
               [](const Element& element) { return text_of(element); });
}

/// What depends on the kind of tree.
template <class Index, Layout layout>
struct Kind {
  static constexpr bool kPre = layout == Layout::pre_indexed;
  static constexpr bool kLarge = sizeof(Index) == 4;
  static constexpr const char* kIndex = kLarge ? "uint32_t" : "uint16_t";

  static std::string mesh() { return name(""); }
  static std::string levelled() { return name("WithLevels"); }

  /// Bytes of the two structs on a 32-bit core.
  static constexpr std::size_t kMeshBytes = kLarge ? 80 : 64;
  static constexpr std::size_t kLevelledBytes = kMeshBytes + 8;

 private:
  static std::string name(const char* suffix) {
    return std::string("flashbvh::") + (kPre ? "Pre" : "") + "Mesh" + suffix + (kLarge ? "32" : "");
  }
};

/// In flash, an array with the gap that may follow it.
template <class Element>
std::size_t bytes_of(const std::vector<Element>& elements) {
  return (elements.size() * sizeof(Element) + 3) / 4 * 4;
}

std::string text_of(const Constant& constant) {
  std::string name = "k";
  bool begins_word = true;
  for (const char* c = constant.name; *c != '\0'; ++c) {
    if (*c != '_') {
      name += begins_word ? static_cast<char>(*c - 'a' + 'A') : *c;
    }
    begins_word = *c == '_';
  }
  return concat("constexpr uint32_t ", name, " = ", constant.value, ";  ///< ", constant.comment,
                "\n");
}

template <class Index, Layout layout>
std::string constants(const bake::BakedTree<Index, layout>& baked, const std::string& unit) {
  using MeshKind = Kind<Index, layout>;
  const std::size_t levels =
      MeshKind::kLevelledBytes + bytes_of(baked.levels) + bytes_of(baked.climb);
  std::vector<Constant> numbers = constants_of(baked);
  numbers.push_back({"flash_bytes", flash_bytes(baked), "what `mesh` links, on a 32-bit core"});
  numbers.push_back({"level_bytes", levels, "what `levelled_mesh` adds to that"});
  std::string text;
  for (const Constant& number : numbers) {
    text += text_of(number);
  }
  return text +
         "/// For flashbvh/time_bound.hpp.\n"
         "constexpr flashbvh::TreeSize kTreeSize = {kDepth, kArity, kLeafSize, kLeafCount, "
         "kTriangleCount};\n"
         "constexpr double kCell = " +
         floating_literal(baked.cell) + ";  ///< in " + (unit.empty() ? "the mesh's unit" : unit) +
         "\n" + "constexpr float kCellsPerUnit = " + cells_per_unit_literal(baked.cell) +
         ";  ///< for flashbvh/float.hpp\n";
}

/// Of flashbvh::Unit.
const char* enumerator_of(Unit unit) {
  constexpr const char* kNames[kUnitCount] = {"none", "nm",  "um",   "mm",  "cm",
                                              "m",    "mil", "inch", "foot"};
  return kNames[static_cast<std::size_t>(unit)];
}

template <class Index, Layout layout>
std::string header(const bake::BakedTree<Index, layout>& baked, const OutputName& name,
                   const std::string& unit) {
  using MeshKind = Kind<Index, layout>;
  const std::string guard = "FLASHBVH_BAKED_" + name.identifier + "_HPP";
  return "// Written by `flashbvh bake`; bake again instead of changing it.\n"
         "#ifndef " +
         guard + "\n#define " + guard +
         "\n\n"
         "#include <stdint.h>\n\n"
         "#include \"flashbvh/mesh.hpp\"\n"
         "#include \"flashbvh/version.hpp\"\n\n" +
         version_guard(name) + "\nnamespace " + name.identifier + " {\n\n" +
         constants(baked, unit) +
         "\n/// For every query but the alternating ones.\n"
         "extern const " +
         MeshKind::mesh() +
         " mesh;\n"
         "/// The same with the levels that alternating-stack and stackless need.\n"
         "extern const " +
         MeshKind::levelled() +
         " levelled_mesh;\n\n"
         "}  // namespace " +
         name.identifier + "\n\n#endif\n";
}

template <class Index, Layout layout>
std::string source(const bake::BakedTree<Index, layout>& baked, const OutputName& name) {
  using MeshKind = Kind<Index, layout>;
  const std::string index = MeshKind::kIndex;
  std::string text =
      "// Written by `flashbvh bake`; bake again instead of changing it.\n"
      "#include \"" +
      name.stem + ".fbvh.hpp\"\n\nnamespace " + name.identifier + " {\nnamespace {\n\n";
  text += arrays_of_mesh(baked) + "\n";
  const char* const climb = MeshKind::kPre ? "kParents" : "kRightChildLevels";
  text += array_of(index, "kLevels", baked.levels) + "\n" + array_of(index, climb, baked.climb);
  text += "\n}  // namespace\n\n";
  text += "const " + MeshKind::mesh() + " mesh = " + view_of_mesh(baked, {}) + ";\n\n";
  text += "const " + MeshKind::levelled() + " levelled_mesh = {\n    " + view_of_mesh(baked, {}) +
          ",\n    kLevels, " + climb + "};\n\n";
  return text + "}  // namespace " + name.identifier + "\n";
}

}  // namespace

template <class Index, Layout layout>
std::size_t flash_bytes(const bake::BakedTree<Index, layout>& baked) {
  return Kind<Index, layout>::kMeshBytes + bytes_of(baked.nodes) + bytes_of(baked.triangles) +
         bytes_of(baked.triangle_ids) + bytes_of(baked.leaf_offsets) + bytes_of(baked.vertices) +
         bytes_of(baked.shell_vertices);
}

std::uint64_t flash_bytes(const ImageHeader& header) {
  const ImageOffsets at = image_offsets(header);
  const std::size_t mesh = header.index_bits == 32
                               ? Kind<std::uint32_t, Layout::post_indexed>::kMeshBytes
                               : Kind<std::uint16_t, Layout::post_indexed>::kMeshBytes;
  return mesh + (at.levels - at.nodes) + (at.name - at.triangles);
}

template <class Index, Layout layout>
std::string arrays_of_mesh(const bake::BakedTree<Index, layout>& baked) {
  const std::string index = Kind<Index, layout>::kIndex;
  std::string text = array_of("flashbvh::Node<" + index + ">", "kNodes", baked.nodes) + "\n";
  text += array_of("flashbvh::Corners<" + index + ">", "kTriangles", baked.triangles) + "\n";
  text += array_of(index, "kTriangleIds", baked.triangle_ids) + "\n";
  if (!baked.leaf_offsets.empty()) {
    text += array_of(index, "kLeafOffsets", baked.leaf_offsets) + "\n";
  }
  text += array_of("flashbvh::Vertex", "kVertices", baked.vertices) + "\n";
  return text + array_of(index, "kShellVertices", baked.shell_vertices);
}

template <class Index, Layout layout>
std::string view_of_mesh(const bake::BakedTree<Index, layout>& baked, const std::string& scope) {
  std::uint64_t cell_bits = 0;
  std::memcpy(&cell_bits, &baked.cell, sizeof cell_bits);
  const auto count = [](std::size_t value) { return text_of(static_cast<Index>(value)); };
  return concat("{{", scope, "kNodes, ", count(baked.nodes.size()), ", ", count(baked.leaf_count),
                ", ", count(baked.stack_need), "},\n    ", scope, "kTriangles, ", scope,
                "kTriangleIds, ", (baked.leaf_offsets.empty() ? "nullptr" : scope + "kLeafOffsets"),
                ", ", scope, "kVertices, ", scope, "kShellVertices,\n    ",
                count(baked.triangles.size()), ", ", count(baked.vertices.size()), ", ",
                count(baked.shell_vertices.size()), ", ", baked.longest_edge, ",\n    {",
                baked.origin[0], ", ", baked.origin[1], ", ", baked.origin[2],
                "}, flashbvh::Unit::", enumerator_of(baked.unit), ", ",
                (baked.is_closed ? "true" : "false"), ", ", hex(cell_bits, 16), "}");
}

template <class Index, Layout layout>
SourceFiles cpp_of(const bake::BakedTree<Index, layout>& baked, const OutputName& name,
                   const std::string& unit) {
  return {header(baked, name, unit), source(baked, name)};
}

#define FLASHBVH_KIND(Index, layout)                                                            \
  template std::size_t flash_bytes(const bake::BakedTree<Index, layout>&);                      \
  template std::string arrays_of_mesh(const bake::BakedTree<Index, layout>&);                   \
  template std::string view_of_mesh(const bake::BakedTree<Index, layout>&, const std::string&); \
  template SourceFiles cpp_of(const bake::BakedTree<Index, layout>&, const OutputName&,         \
                              const std::string&);
FLASHBVH_FOR_EACH_KIND(FLASHBVH_KIND)
#undef FLASHBVH_KIND

}  // namespace flashbvh::tool
