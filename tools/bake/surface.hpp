// What a mesh's surface is made of.
#pragma once

#include <cstdint>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::bake {

/// See flashbvh::Mesh.
struct Surface {
  std::vector<std::uint32_t> shell_vertices;
  std::uint16_t longest_edge = 0;
  bool is_closed = false;
};

/// O(n log n).
Surface surface_of(const LatticeMesh& mesh);

}  // namespace flashbvh::bake
