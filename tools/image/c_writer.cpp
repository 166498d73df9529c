#include "image/c_writer.hpp"

#include <algorithm>
#include <type_traits>

#include "image/source_text.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr const char* kWritten =
    "/* Written by `flashbvh bake`; bake again instead of changing it. */\n";

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return text;
}

std::string enumerators(const std::vector<Constant>& constants, const OutputName& name) {
  std::string text;
  for (const Constant& constant : constants) {
    text += concat("  ", name.word, "_", upper(constant.name), " = ", constant.value, ", /* ",
                   constant.comment, " */\n");
  }
  return "enum {\n" + text + "};\n";
}

/// For bounds.
std::string tree_size(const std::string& word) {
  std::string text = "/** A flashbvh_tree_size. */\n#define " + word + "_TREE_SIZE \\\n  {";
  for (const char* const part : {"_DEPTH", "_ARITY", "_LEAF_SIZE", "_LEAF_COUNT"}) {
    text += word + part + ", ";
  }
  return text + word + "_TRIANGLE_COUNT}\n";
}

std::string array_name(const OutputName& name, std::size_t words) {
  return concat("uint32_t ", name.word, "_image[", words, "]");
}

}  // namespace

template <class Index, Layout layout>
SourceFiles c_of(const bake::BakedTree<Index, layout>& baked,
                 const std::vector<std::uint32_t>& image, const OutputName& name,
                 const std::string& unit) {
  constexpr bool opens_in_c =
      layout == Layout::post_indexed && std::is_same_v<Index, std::uint16_t>;
  std::vector<Constant> constants = constants_of(baked);
  constants.push_back({"image_bytes", image.size() * sizeof image[0], "of the array"});
  const std::string guard = "FLASHBVH_BAKED_" + name.word + "_H";
  const std::string declaration = array_name(name, image.size());
  SourceFiles files;
  files.header = kWritten + ("#ifndef " + guard) + "\n#define " + guard +
                 "\n\n#include <stdint.h>\n\n#include \"flashbvh/plain/byte_order.h\"\n"
                 "#include \"flashbvh/version.hpp\"\n\n" +
                 version_guard(name) + "\n" + enumerators(constants, name) + tree_size(name.word) +
                 "#define " + name.word + "_CELL " + floating_literal(baked.cell) + " /* in " +
                 (unit.empty() ? "the mesh's unit" : unit) + " */\n#define " + name.word +
                 "_CELLS_PER_UNIT " + cells_per_unit_literal(baked.cell) +
                 "\n\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n/** For " +
                 (opens_in_c ? "flashbvh_open()" : "open_image() of C++: C has no such meshes") +
                 ". */\nextern const " + declaration +
                 ";\n\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
  files.source = kWritten + ("#include \"" + name.stem) + ".fbvh.h\"\n\n" +
                 array(declaration, image, [](std::uint32_t word) { return hex(word, 8); });
  return files;
}

#define FLASHBVH_KIND(Index, layout)                                              \
  template SourceFiles c_of(const bake::BakedTree<Index, layout>&,                \
                            const std::vector<std::uint32_t>&, const OutputName&, \
                            const std::string&);
FLASHBVH_FOR_EACH_KIND(FLASHBVH_KIND)
#undef FLASHBVH_KIND

}  // namespace flashbvh::tool
