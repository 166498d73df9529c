// A tree over a lattice mesh, of any shape, before it is laid out in an array.
#pragma once

#include <cstdint>
#include <vector>

#include "bake/mesh.hpp"
#include "flashbvh/lattice.hpp"

namespace flashbvh::bake {

/// A leaf has no children and at least one triangle, an internal node the reverse.
struct BuildNode {
  Box box{};
  std::vector<std::uint32_t> children;   ///< indices into BuildTree::nodes, first to last
  std::vector<std::uint32_t> triangles;  ///< numbers in the source mesh

  bool is_leaf() const { return children.empty(); }
};

/// The root is node 0. Every node but the root is the child of exactly one.
struct BuildTree {
  std::vector<BuildNode> nodes;
};

/// The box of a triangle, and the smallest box round two boxes.
Box box_of(const LatticeMesh& mesh, std::uint32_t triangle);
Box join(const Box& a, const Box& b);

/// The paper's builder (section 9): top-down, half the triangles on each side of the middle along
/// the longest axis of the node's box, down to `leaf_size` triangles. Ordered by the sum of the
/// corners, ties by number: the result is the same on every machine. At least one triangle.
/// O(n log^2 n).
BuildTree build_median(const LatticeMesh& mesh, std::uint32_t leaf_size);

/// By the surface area heuristic: takes the best of all splits along the three axes, then moves
/// subtrees to places where they cost less (sweep.cpp, reinsert.cpp). Subtrees of up to `leaf_size`
/// triangles become leaves, or those that kLeavesByMesh chooses. In integers, ties by position and
/// number: the result is the same on every machine. At least one triangle. O(n log n) and O(n) per
/// level.
BuildTree build_sah(const LatticeMesh& mesh, std::uint32_t leaf_size);

/// The tree with up to `arity` children per node and unchanged leaves. Each node repeatedly
/// replaces the internal child with the highest chance of overlap by its children. It ends when
/// they do not fit, or the child's test often saves theirs (collapse.cpp). 2 keeps a binary tree.
BuildTree collapse(const BuildTree& binary, std::uint32_t arity);

/// In place of a leaf size: leaves of up to kMostByMesh triangles. Merges that cost
/// queries least come first, until an image takes kBytesByMesh bytes a triangle.
constexpr std::uint32_t kLeavesByMesh = 0;
constexpr std::uint32_t kMostByMesh = 4;
constexpr std::uint32_t kBytesByMesh = 27;
/// The default for meshes that bend, whose leaves have no slabs.
constexpr std::uint32_t kBendingLeafSize = 2;

/// The most triangles in a leaf, for messages.
constexpr std::uint32_t most_in_leaf(std::uint32_t leaf_size) {
  return leaf_size == kLeavesByMesh ? kMostByMesh : leaf_size;
}

/// The default of `flashbvh bake`.
constexpr std::uint32_t kDefaultLeafSize = kLeavesByMesh;
constexpr std::uint32_t kDefaultArity = 4;
BuildTree build_default(const LatticeMesh& mesh, std::uint32_t leaf_size = kDefaultLeafSize);

}  // namespace flashbvh::bake
