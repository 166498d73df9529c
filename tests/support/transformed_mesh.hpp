// brute_force() of transformed_vertex.hpp for meshes before baking.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "bake/mesh.hpp"
#include "support/transformed_vertex.hpp"

namespace flashbvh::test {

/// All pairs of triangles that intersect, in order.
inline std::vector<std::pair<std::uint32_t, std::uint32_t>> brute_force(const bake::LatticeMesh& a,
                                                                        const bake::LatticeMesh& b,
                                                                        const Pose& pose) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  brute_force(a, static_cast<std::uint32_t>(a.triangles.size()), b,
              static_cast<std::uint32_t>(b.triangles.size()), pose,
              [&pairs](std::uint32_t i, std::uint32_t j) { pairs.emplace_back(i, j); });
  return pairs;
}

}  // namespace flashbvh::test
