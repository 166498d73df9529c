// A binary tree with one triangle per leaf, in which subtrees can be moved.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bake/build_tree.hpp"
#include "bake/mesh.hpp"

namespace flashbvh::bake {

constexpr std::uint32_t kNoNode = 0xFFFFFFFFu;

struct BinaryNode {
  Box box{};
  std::uint64_t surface = 0;  ///< half_surface(box)
  std::uint32_t parent = kNoNode;
  std::array<std::uint32_t, 2> children = {kNoNode, kNoNode};
  std::uint32_t triangle = 0;  ///< of a leaf: number in the source mesh

  bool is_leaf() const { return children[0] == kNoNode; }
};

/// The root is node 0.
struct BinaryTree {
  std::vector<BinaryNode> nodes;
};

/// The tree over the triangles of the mesh, at least one, by the surface area heuristic.
/// O(n log n) to sort, then O(n) per level.
BinaryTree sweep(const LatticeMesh& mesh);

/// Moves subtrees to places where they cost less. The tree's cost never grows.
void reinsert_all(BinaryTree& tree);

/// The tree with each largest subtree of up to `leaf_size` triangles made a leaf.
BuildTree with_leaves(const BinaryTree& tree, std::uint32_t leaf_size);

}  // namespace flashbvh::bake
