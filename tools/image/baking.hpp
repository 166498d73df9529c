// A mesh baked, in any of the four kinds of tree.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "bake/baked_tree.hpp"
#include "mesh/import.hpp"
#include "simplify/coarsening.hpp"

namespace flashbvh::tool {

/// How triangles are grouped.
enum class Builder : std::uint8_t {
  median,  ///< the paper's
  sah,
};

enum class IndexWidth : std::uint8_t { bits_16, bits_32 };

/// Leaves that spare flash, for more instructions where meshes are near.
constexpr std::uint32_t kLargeLeaf = 5;
constexpr std::uint32_t kLargestLeaf = 10;  ///< that --fit chooses

/// Lengths are in the unit of the mesh.
struct BakeOptions {
  std::string unit;  ///< its name, for messages; empty if it is not known
  Layout layout = Layout::post_indexed;
  IndexWidth index_width = IndexWidth::bits_16;
  Builder builder = Builder::sah;
  std::uint32_t leaf_size = bake::kDefaultLeafSize;  ///< most triangles in a leaf
  std::uint32_t arity = bake::kDefaultArity;         ///< most children of a node
  std::optional<double> cell;                        ///< by default the finest that the mesh fits
  std::optional<double> max_deviation;               ///< how far a point may lie from the file's
  bool offers_wide_indices = true;                   ///< messages may offer them to the user
  bool drop_degenerate = false;                      ///< before or after rounding
  bool drop_duplicate = false;                       ///< on the lattice; the first of them stays
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
double finest_cell(const InputMesh& input);

/// What trees of all kinds are built of.
struct RoundedMesh {
  bake::LatticeMesh lattice;  ///< without what was dropped
  TriangleIds kept;           ///< the file's numbers of its triangles
  MeshDefects defects;        ///< before any triangle was dropped
};

/// UserError, naming the mesh's file, if the mesh is too large for the cell, if rounding moves a
/// vertex too far, or if no triangle is left.
RoundedMesh round_mesh(const InputMesh& input, const BakeOptions& options);
/// UserError if the mesh or its tree is too large for the indices.
AnyBakedTree build_tree(const InputMesh& input, const RoundedMesh& rounded,
                        const BakeOptions& options);
/// Both, one after the other.
BakedMesh bake(const InputMesh& input, const BakeOptions& options);
/// Of `coarse`, made of the input's mesh, in its place: triangles are numbered again. UserError as
/// well if it deviates too far.
BakedMesh bake(const InputMesh& input, const BakeOptions& options,
               const simplify::Coarsening& coarse);

/// For messages: what simplifying to `length` would leave of it, "with --simplify 0.1 1200 of them
/// are left, in 31000 bytes".
std::string offer_of(const InputMesh& input, const BakeOptions& options, double length);

/// Bytes of the image of such a mesh, by this name; infinite if it can't be baked. Nothing is
/// certified for it.
double coarse_bytes(const InputMesh& input, const simplify::Coarsening& coarse,
                    const BakeOptions& options, const std::string& name, bool levels = false);

}  // namespace flashbvh::tool
