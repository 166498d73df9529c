// What no query on two meshes exceeds, however bad their trees are.
#pragma once

#include <algorithm>
#include <cstdint>

#include "flashbvh/time_bound.hpp"

namespace flashbvh::test {

/// As far as work depends on it.
template <class Mesh>
TreeSize size_of(const Mesh& mesh) {
  TreeSize size = {0, 0, 1, mesh.leaf_count, mesh.triangle_count};
  for (std::uint32_t leaf = 0; leaf < mesh.leaf_count; ++leaf) {
    size.leaf_size = std::max(size.leaf_size, mesh.triangles_in(leaf));
  }
  return size;
}

/// A query visits each pair of nodes once at most.
template <class Mesh>
std::uint32_t most_visits_of_nodes(const Mesh& a, const Mesh& b) {
  const std::uint64_t pairs = std::uint64_t{a.node_count} * b.node_count;
  return pairs < UINT32_MAX ? static_cast<std::uint32_t>(pairs) : UINT32_MAX;
}

/// A leaf taken as a shape with each visit, and all triangles tested.
template <class Mesh>
std::uint32_t most_work_of_nodes(const Mesh& a, const Mesh& b) {
  const std::uint64_t visits = most_visits_of_nodes(a, b);
  const std::uint64_t work = most_work(size_of(a), size_of(b), visits, visits);
  return work < UINT32_MAX ? static_cast<std::uint32_t>(work) : UINT32_MAX;
}

}  // namespace flashbvh::test
