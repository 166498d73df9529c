// The cost of a deformable mesh (flashbvh/deformable.hpp).
#pragma once

#include <cstddef>
#include <cstdint>

#include "flashbvh/mesh.hpp"

namespace flashbvh::bake {

struct BendingCost {
  std::size_t ram_bytes;           ///< nodes and vertices
  std::size_t refit_instructions;  ///< of a whole refit, on a Cortex-M4F at -O2, within 5 %
};

/// tests/figures/bending.cpp measures the instructions.
template <class Mesh>
BendingCost bending_cost(const Mesh& mesh) {
  std::size_t refit = 12 * std::size_t{mesh.node_count};
  for (std::uint32_t leaf = 0; leaf < mesh.leaf_count; ++leaf) {
    const std::uint32_t first = mesh.first_triangle(leaf);
    std::uint32_t end = mesh.end_triangle(leaf);
    const bool is_many = end - first > 2;
    refit += is_many ? 52 : 0;
    while (end != first) {
      const auto* const last = mesh.triangles + end - 1;
      const bool is_quad = end - first > 1 && flashbvh::is_quad(last[-1], last[0]);
      refit += is_quad || is_many ? 63 : end - first == 2 ? 47 : 39;
      end -= is_quad ? 2 : 1;
    }
  }
  return {mesh.node_count * sizeof *mesh.nodes + mesh.vertex_count * sizeof *mesh.vertices, refit};
}

}  // namespace flashbvh::bake
