// Bakes a mesh into any of the four kinds of tree.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "image/rounding.hpp"
#include "simplify/coarsening.hpp"

namespace flashbvh::tool {

/// A tree of any layout and width of indices.
using AnyBakedTree = std::variant<bake::BakedTree<std::uint16_t, Layout::pre_indexed>,
                                  bake::BakedTree<std::uint16_t, Layout::post_indexed>,
                                  bake::BakedTree<std::uint32_t, Layout::pre_indexed>,
                                  bake::BakedTree<std::uint32_t, Layout::post_indexed>>;

struct BakedMesh {
  AnyBakedTree tree;
  MeshDefects defects;  ///< before any triangle was dropped
  double dropped = 0;   ///< RoundedMesh::dropped
};

/// Builds a tree. UserError if the mesh or its tree is too large for the indices.
AnyBakedTree build_tree(const InputMesh& input, const RoundedMesh& rounded,
                        const BakeOptions& options);
/// Rounds a mesh and builds its tree.
BakedMesh bake(const InputMesh& input, const BakeOptions& options);
/// Bakes `coarse`, a simplification of the input's mesh with this cell, in its place; numbers
/// triangles again. UserError, too, if it deviates too far.
BakedMesh bake(const InputMesh& input, const BakeOptions& options,
               const simplify::Coarsening& coarse);

/// The image's size in bytes for such a mesh of this name; infinite if it can't be baked. Does not
/// certify its deviation.
double coarse_bytes(const InputMesh& input, const simplify::Coarsening& coarse,
                    const BakeOptions& options, const std::string& name, bool levels = false);

}  // namespace flashbvh::tool
