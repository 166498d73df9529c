// One mesh baked with the options of the command line, in any of the four kinds of tree.
#ifndef FLASHBVH_TOOLS_IMAGE_BAKING_HPP
#define FLASHBVH_TOOLS_IMAGE_BAKING_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "bake/baked_tree.hpp"
#include "mesh/defects.hpp"

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
  std::optional<double> max_deviation;               ///< how far rounding may move a vertex
  bool drop_degenerate = false;                      ///< before or after rounding
  bool drop_duplicate = false;                       ///< on the lattice; the first of them stays
};

/// A mesh as its file has it.
struct InputMesh {
  std::string path;
  bake::SourceMesh mesh;       ///< converted to the common unit
  TriangleNumbers degenerate;  ///< before it was converted
};

/// Whatever the layout and the width of the indices.
using AnyBakedTree = std::variant<bake::BakedTree<std::uint16_t, Layout::pre_indexed>,
                                  bake::BakedTree<std::uint16_t, Layout::post_indexed>,
                                  bake::BakedTree<std::uint32_t, Layout::pre_indexed>,
                                  bake::BakedTree<std::uint32_t, Layout::post_indexed>>;

struct BakedMesh {
  AnyBakedTree tree;
  MeshDefects defects;  ///< before any triangle was dropped
};

/// The finest cell with which the mesh fits the lattice, and of which firmware can hold the value
/// in a float.
double finest_float_cell(const bake::SourceMesh& mesh);

/// UserError, naming the mesh's file, if the mesh is too large for the cell or for the indices, if
/// rounding moves a vertex too far, or if no triangle is left.
BakedMesh bake_mesh(const InputMesh& input, double cell, const BakeOptions& options);

}  // namespace flashbvh::tool

#endif
