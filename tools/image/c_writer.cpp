#include "image/c_writer.hpp"

#include <cstring>

#include "bake/quantise.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/version.hpp"
#include "image/fine_length.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Refuses a library with another interface: below 1.0 the minor version counts, too.
std::string version_guard(const OutputName& name) {
  std::string condition = concat("#if FLASHBVH_VERSION_MAJOR != ", FLASHBVH_VERSION_MAJOR);
  std::string version = std::to_string(FLASHBVH_VERSION_MAJOR);
  if (FLASHBVH_VERSION_MAJOR == 0) {
    condition += concat(" || FLASHBVH_VERSION_MINOR != ", FLASHBVH_VERSION_MINOR);
    version += concat(".", FLASHBVH_VERSION_MINOR);
  }
  return condition + "\n#error \"" + name.word + " was baked by flashbvh " + version +
         "; bake it again with this version\"\n#endif\n";
}

/// "{...}", with as many words per line as fit 100 columns.
std::string words_of(const std::vector<std::uint32_t>& image) {
  constexpr std::size_t kWordsPerLine = 7;
  std::string text = "{";
  for (std::size_t i = 0; i < image.size(); ++i) {
    text += (i % kWordsPerLine == 0 ? "\n    " : " ") + hex(image[i], 8) + ",";
  }
  return text + "\n}";
}

/// Computed as in firmware from an image's cell; 0 if no finite float is near.
std::string cells_per_unit_literal(double cell) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &cell, sizeof bits);
  return float_literal(cells_per_unit(bits));
}

/// The macro for bounds of queries.
std::string tree_size(const std::string& word) {
  std::string text = "/** A flashbvh_tree_size. */\n#define " + word + "_TREE_SIZE \\\n  {";
  for (const char* const part : {"_DEPTH", "_ARITY", "_LEAF_SIZE", "_LEAF_COUNT"}) {
    text += word + part + ", ";
  }
  return text + word + "_TRIANGLE_COUNT}\n";
}

/// In the unit, and in 1/256 cell, rounded up, as firmware adds it to a distance.
std::string deviation_macros(const std::string& word, double deviation, double cell,
                             const std::string& unit) {
  return concat("#define ", word, "_DEVIATION ", floating_literal(deviation), " /* in ",
                unit.empty() ? "the mesh's unit" : unit, ": from the file's mesh */\n#define ",
                word, "_DEVIATION_FINE ", fixed(bake::parts_above(deviation, cell, kFineOne), 0),
                " /* the same in 1/256 cell */\n");
}

std::string view_of(const ImageHeader& header) {
  const bool is_pre = header.layout == static_cast<std::uint8_t>(Layout::pre_indexed);
  const bool is_wide = header.index_bits == 32;
  return concat(
      "view_unchecked<flashbvh::", is_pre ? "Pre" : "", "Mesh", is_wide ? "32" : "",
      is_pre || is_wide ? ">() of C++: C has no such meshes." : ">(), flashbvh_view_unchecked().");
}

}  // namespace

std::string hex(std::uint64_t value, unsigned digits) {
  std::string text = "0x";
  for (unsigned i = digits; i-- != 0;) {
    text += "0123456789abcdef"[value >> (4 * i) & 15];
  }
  return text + "u";
}

std::string count_macros(const std::string& word, const std::vector<Count>& counts) {
  std::string text;
  for (const auto& [name, value, comment] : counts) {
    text += concat("#define ", word, "_", name, " ", value, " /* ", comment, " */\n");
  }
  return text;
}

std::string cell_macros(const std::string& word, double cell, const std::string& unit) {
  return concat("#define ", word, "_CELL ", floating_literal(cell), " /* in ",
                unit.empty() ? "the mesh's unit" : unit, " */\n#define ", word, "_CELLS_PER_UNIT ",
                cells_per_unit_literal(cell), "\n");
}

SourceFiles image_in_c(const std::vector<std::uint32_t>& image, const OutputName& name,
                       const SourceFrame& frame, const std::string& about) {
  const std::string written = concat("/* Written by `flashbvh ", frame.command,
                                     "`; run it again instead of changing this. */\n");
  const std::string guard = "FLASHBVH_BAKED_" + frame.array + "_H";
  const std::string array = concat("const uint32_t ", frame.array, "[", image.size(), "]");
  SourceFiles files;
  files.header = written + ("#ifndef " + guard) + "\n#define " + guard +
                 "\n\n#include <stdint.h>\n\n#include \"flashbvh/plain/byte_order.h\"\n"
                 "#include \"flashbvh/version.hpp\"\n\n" +
                 version_guard(name) + "\n" + about +
                 "\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n/** For " + frame.array_comment +
                 " */\nextern " + array + ";\n\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
  files.source = written + ("#include \"" + name.stem) + frame.extension + ".h\"\n\n" + array +
                 " = " + words_of(image) + ";\n";
  return files;
}

SourceFiles mesh_in_c(const std::vector<std::uint32_t>& image, const OutputName& name,
                      const std::string& unit) {
  ImageHeader header;
  std::memcpy(&header, image.data(), sizeof header);
  double cell = 0;
  std::memcpy(&cell, header.cell, sizeof cell);
  float deviation = 0;
  std::memcpy(&deviation, &header.deviation, sizeof deviation);
  const std::string& word = name.word;
  const std::string about =
      count_macros(word,
                   {{"NODE_COUNT", header.node_count, "of the tree"},
                    {"DEPTH", header.depth, "of the deepest leaf; the root has depth 0"},
                    {"STACK_NEED", header.stack_need, "see flashbvh::stack_entries()"},
                    {"LEAF_COUNT", header.leaf_count, "see flashbvh::most_visits()"},
                    {"LEAF_SIZE", header.leaf_size, "most triangles in a leaf"},
                    {"ARITY", header.arity, "most children of a node; 0 if the root is a leaf"},
                    {"TRIANGLE_COUNT", header.triangle_count, "that were kept of the mesh file"},
                    {"VERTEX_COUNT", header.vertex_count, "on the lattice, joined"},
                    {"IMAGE_BYTES", header.byte_count, "of the array"}}) +
      tree_size(word) + cell_macros(word, cell, unit) +
      deviation_macros(word, static_cast<double>(deviation), cell, unit);
  return image_in_c(image, name, {"bake", ".fbvh", word + "_image", view_of(header)}, about);
}

}  // namespace flashbvh::tool
