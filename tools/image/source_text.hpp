// What baked trees have in common as C++ and as C.
#ifndef FLASHBVH_TOOLS_IMAGE_SOURCE_TEXT_HPP
#define FLASHBVH_TOOLS_IMAGE_SOURCE_TEXT_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "bake/baked_tree.hpp"
#include "image/output_name.hpp"

namespace flashbvh::tool {

/// A baked mesh in a language: the same text for the same arguments, on every machine.
struct SourceFiles {
  std::string header;  ///< NAME.fbvh.hpp or .h
  std::string source;  ///< NAME.fbvh.cpp or .c
};

/// "0x00ffu" for 255 and four digits.
std::string hex(std::uint64_t value, unsigned digits);

/// Refuses a library with another interface: below 1.0 the minor version counts, too.
std::string version_guard(const OutputName& name);

/// As firmware works it out from an image's cell; 0 if no finite float is near.
std::string cells_per_unit_literal(double cell);

/// A number that firmware needs when it is compiled.
struct Constant {
  const char* name;  ///< words with a '_' between
  std::size_t value;
  const char* comment;
};

template <class Index, Layout layout>
std::vector<Constant> constants_of(const bake::BakedTree<Index, layout>& baked) {
  return {{"node_count", baked.nodes.size(), "of the tree"},
          {"depth", baked.depth, "of the deepest leaf; the root has depth 0"},
          {"stack_need", baked.stack_need, "see flashbvh::stack_entries()"},
          {"leaf_count", baked.leaf_count, "see flashbvh::most_visits()"},
          {"leaf_size", baked.leaf_size, "most triangles in a leaf"},
          {"arity", baked.arity, "most children of a node; 0 if the root is a leaf"},
          {"triangle_count", baked.triangles.size(), "that were kept of the mesh file"},
          {"vertex_count", baked.vertices.size(), "on the lattice, joined"}};
}

/// "const DECLARATION = {...};", as many elements a line as fit. `text_of`: of an element.
template <class Element, class TextOf>
std::string array(const std::string& declaration, const std::vector<Element>& elements,
                  const TextOf& text_of) {
  constexpr std::size_t kColumns = 100;
  std::string text = "const " + declaration + " = {";
  std::string line;
  for (const Element& element : elements) {
    const std::string next = text_of(element) + ",";
    if (line.empty() || line.size() + 1 + next.size() > kColumns) {
      text += line + "\n";
      line = "    " + next;
    } else {
      line += " " + next;
    }
  }
  return text + line + "\n};\n";
}

}  // namespace flashbvh::tool

#endif
