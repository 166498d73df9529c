// Upper bounds of the work of any query on two meshes, however bad their trees are.
#pragma once

#include <algorithm>
#include <cstdint>

#include "flashbvh/time_bound.hpp"

namespace flashbvh::test {

/// The tree's sizes on which the work depends.
template <class Mesh>
TreeSize size_of(const Mesh& mesh) {
  TreeSize size = {0, 0, 1, mesh.leaf_count, mesh.triangle_count};
  for (std::uint32_t leaf = 0; leaf < mesh.leaf_count; ++leaf) {
    size.leaf_size = std::max(size.leaf_size, mesh.triangles_in(leaf));
  }
  return size;
}

/// An upper bound of visits: a query visits each pair of nodes at most once.
template <class Mesh>
std::uint32_t most_visits_of_nodes(const Mesh& a, const Mesh& b) {
  const std::uint64_t pairs = std::uint64_t{a.node_count} * b.node_count;
  return pairs < UINT32_MAX ? static_cast<std::uint32_t>(pairs) : UINT32_MAX;
}

/// An upper bound of work: each visit loads a leaf's planes, and all triangles are tested.
template <class Mesh>
std::uint32_t most_work_of_nodes(const Mesh& a, const Mesh& b) {
  const std::uint64_t visits = most_visits_of_nodes(a, b);
  const std::uint64_t work = most_work(size_of(a), size_of(b), visits, visits);
  return work < UINT32_MAX ? static_cast<std::uint32_t>(work) : UINT32_MAX;
}

}  // namespace flashbvh::test
