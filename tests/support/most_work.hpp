// What no query on two meshes exceeds, however bad their trees are.
#ifndef FLASHBVH_TESTS_MOST_WORK_HPP
#define FLASHBVH_TESTS_MOST_WORK_HPP

#include <cstdint>

#include "flashbvh/detail/work.hpp"

namespace flashbvh::test {

/// A query visits each pair of nodes once at most.
template <class Mesh>
std::uint32_t most_visits_of_nodes(const Mesh& a, const Mesh& b) {
  const std::uint64_t pairs = std::uint64_t{a.node_count} * b.node_count;
  return pairs < UINT32_MAX ? static_cast<std::uint32_t>(pairs) : UINT32_MAX;
}

/// A leaf taken as a shape with each visit, and all triangles tested.
template <class Mesh>
std::uint32_t most_work_of_nodes(const Mesh& a, const Mesh& b) {
  const std::uint64_t in_a_leaf = a.triangle_count + b.triangle_count;
  const std::uint64_t work =
      std::uint64_t{most_visits_of_nodes(a, b)} * (1 + detail::kShapeWork + in_a_leaf) +
      std::uint64_t{detail::kTrianglePairWork} * a.triangle_count * b.triangle_count;
  return work < UINT32_MAX ? static_cast<std::uint32_t>(work) : UINT32_MAX;
}

}  // namespace flashbvh::test

#endif
