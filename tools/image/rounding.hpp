// How meshes are baked; and their rounding to the lattice, which is the input of all kinds of tree.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bake/baked_tree.hpp"
#include "mesh/import.hpp"

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
  bool drop_degenerate = false;                      ///< before or after rounding
  bool drop_duplicate = false;                       ///< on the lattice; the first of them stays
};

/// A length for messages.
std::string text_of(double length, const BakeOptions& options);

/// The mesh on the lattice. UserError, naming its file, if it is too large for the cell.
bake::LatticeMesh lattice_of(const InputMesh& input, const BakeOptions& options);

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

}  // namespace flashbvh::tool
