// One mesh baked with the options of the command line, in any of the four kinds of tree.
#ifndef FLASHBVH_TOOLS_BAKING_HPP
#define FLASHBVH_TOOLS_BAKING_HPP

#include <cstdint>
#include <string>
#include <variant>

#include "bake/baked_tree.hpp"

namespace flashbvh::tool {

/// How triangles are grouped.
enum class Builder : std::uint8_t {
  median,  ///< the paper's
  sah,
};

struct BakeOptions {
  Layout layout = Layout::post_indexed;
  unsigned index_bits = 16;  ///< 16 or 32
  Builder builder = Builder::sah;
  std::uint32_t leaf_size = bake::kDefaultLeafSize;  ///< most triangles in a leaf
  std::uint32_t arity = bake::kDefaultArity;         ///< most children of a node
};

/// Whatever the layout and the width of the indices.
using AnyBakedTree = std::variant<bake::BakedTree<std::uint16_t, Layout::pre_indexed>,
                                  bake::BakedTree<std::uint16_t, Layout::post_indexed>,
                                  bake::BakedTree<std::uint32_t, Layout::pre_indexed>,
                                  bake::BakedTree<std::uint32_t, Layout::post_indexed>>;

struct BakedMesh {
  AnyBakedTree tree;
  std::uint32_t degenerate = 0;  ///< triangles without area on the lattice
  std::uint32_t repeated = 0;    ///< triangles with the corners of an earlier one, on the lattice
};

/// The finest cell with which the mesh fits the lattice, and of which firmware can hold the value
/// in a float.
double finest_float_cell(const bake::SourceMesh& mesh);

/// UserError, naming `path`, if the mesh is too large for the cell or for the indices.
BakedMesh bake_mesh(const bake::SourceMesh& mesh, double cell, const BakeOptions& options,
                    const std::string& path);

}  // namespace flashbvh::tool

#endif
