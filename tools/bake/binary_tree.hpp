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

/// [node]: true if the subtree becomes a leaf: each largest one of up to `leaf_size` triangles.
std::vector<bool> largest_leaves(const BinaryTree& tree, std::uint32_t leaf_size);

/// The same as kLeavesByMesh chooses. `vertices`: of the mesh.
std::vector<bool> leaves_by_mesh(const BinaryTree& tree, std::size_t vertices);

/// The tree with these subtrees made leaves.
BuildTree with_leaves(const BinaryTree& tree, const std::vector<bool>& is_leaf);

}  // namespace flashbvh::bake
