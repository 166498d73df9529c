// Properties of a mesh's surface.
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

/// True if triangles run along each edge equally often in both directions. O(n log n).
bool is_closed(const std::vector<TriangleCorners>& triangles);

/// For each vertex, the first one that triangles connect it to.
std::vector<std::uint32_t> shells_of(const std::vector<TriangleCorners>& triangles,
                                     std::size_t vertex_count);

/// O(n log n).
Surface surface_of(const LatticeMesh& mesh);

}  // namespace flashbvh::bake
