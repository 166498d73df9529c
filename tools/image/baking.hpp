// Bakes a mesh into any of the four kinds of tree.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "bake/baked_tree.hpp"
#include "mesh/import.hpp"
#include "simplify/coarsening.hpp"

namespace flashbvh::tool {

/// The algorithm that groups triangles.
enum class Builder : std::uint8_t {
  median,  ///< the paper's
  sah,
};

enum class IndexWidth : std::uint8_t { bits_16, bits_32 };

/// A leaf size that saves flash and costs instructions where meshes are near.
constexpr std::uint32_t kLargeLeaf = 5;
constexpr std::uint32_t kLargestLeaf = 10;  ///< the most that --fit chooses

/// Lengths are in the unit of the mesh.
struct BakeOptions {
  std::string unit;  ///< its name, for messages; empty if unknown
  Layout layout = Layout::post_indexed;
  IndexWidth index_width = IndexWidth::bits_16;
  Builder builder = Builder::sah;
  std::uint32_t leaf_size = bake::kDefaultLeafSize;  ///< most triangles in a leaf
  std::uint32_t arity = bake::kDefaultArity;         ///< most children of a node
  std::optional<double> cell;                        ///< by default the finest that the mesh fits
  std::optional<double> max_deviation;               ///< of a point from the file's mesh
  bool offers_wide_indices = true;                   ///< messages may suggest them
  bool drop_degenerate = false;                      ///< before or after rounding
  bool drop_duplicate = false;                       ///< on the lattice; the first of them stays
};

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

/// The finest cell with which the mesh fits the lattice and that firmware can hold in a float.
double finest_cell(const InputMesh& input);

/// The input of trees of all kinds.
struct RoundedMesh {
  bake::LatticeMesh lattice;  ///< without dropped triangles
  TriangleIds kept;           ///< the file's numbers of its triangles
  MeshDefects defects;        ///< before any triangle was dropped
  /// How far points of dropped triangles may be from the others, once rounded; the deviation
  /// includes it. 0 if they lie on others.
  double dropped = 0;
};

/// Rounds a mesh. The deviation includes the reader's rounding and dropped triangles. UserError,
/// naming the mesh's file, if the mesh is too large for the cell, if rounding moves a vertex too
/// far, or if no triangle is left.
RoundedMesh round_mesh(const InputMesh& input, const BakeOptions& options);
/// Builds a tree. UserError if the mesh or its tree is too large for the indices.
AnyBakedTree build_tree(const InputMesh& input, const RoundedMesh& rounded,
                        const BakeOptions& options);
/// Rounds a mesh and builds its tree.
BakedMesh bake(const InputMesh& input, const BakeOptions& options);
/// Bakes `coarse`, a simplification of the input's mesh, in its place; numbers triangles again.
/// UserError, too, if it deviates too far.
BakedMesh bake(const InputMesh& input, const BakeOptions& options,
               const simplify::Coarsening& coarse);

/// For messages: the result of simplifying to `length`, "with --simplify 0.1 1200 of them are left,
/// in 31000 bytes", or that it does not fit.
std::string offer_of(const InputMesh& input, const BakeOptions& options, double length);

/// The image's size in bytes for such a mesh of this name; infinite if it can't be baked. Does not
/// certify its deviation.
double coarse_bytes(const InputMesh& input, const simplify::Coarsening& coarse,
                    const BakeOptions& options, const std::string& name, bool levels = false);

}  // namespace flashbvh::tool
