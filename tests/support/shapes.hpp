// Random meshes and trees of every form, small enough to check by brute force.
#pragma once

#include <cstdint>
#include <vector>

#include "bake/baked_tree.hpp"
#include "bake/build_tree.hpp"
#include "bake/mesh.hpp"
#include "support/random.hpp"

namespace flashbvh::test {

/// `count` triangles with corners at most `size` apart, within +-`spread` on each axis.
bake::LatticeMesh random_mesh(Random& random, std::uint32_t count, std::int32_t spread,
                              std::int32_t size);

/// The box of some triangles, at least one.
Box box_of_all(const bake::LatticeMesh& mesh, const std::vector<std::uint32_t>& triangles);

/// Options of a random tree.
struct Shape {
  std::uint32_t arity = 2;       ///< the largest number of children of a node
  std::uint32_t leaf_size = 1;   ///< the largest number of triangles in a leaf
  bool single_children = false;  ///< some nodes have one child
};

/// A tree over all triangles in random order, split at random places.
bake::BuildTree random_tree(Random& random, const bake::LatticeMesh& mesh, const Shape& shape);

/// A binary tree in which each internal node has a leaf as its first (`leaf_first`) or last child.
bake::BuildTree chain(const bake::LatticeMesh& mesh, bool leaf_first);

/// One of the trees above, at random, over all triangles of `mesh`.
bake::BuildTree any_tree(Random& random, const bake::LatticeMesh& mesh);

template <Layout layout>
using Baked = bake::BakedTree<std::uint16_t, layout>;

template <Layout layout = Layout::post_indexed>
Baked<layout> baked(const bake::BuildTree& tree, const bake::LatticeMesh& mesh) {
  return bake::lay_out<std::uint16_t, layout>(tree, mesh);
}

}  // namespace flashbvh::test
