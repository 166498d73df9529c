// Properties of a mesh's surface.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::bake {

/// See flashbvh::Mesh.
struct Surface {
  std::vector<std::uint32_t> shell_vertices;
  std::uint16_t longest_edge = 0;
  bool is_closed = false;
};

/// Sets of connected elements, such as vertices or triangles; each is represented by its first one.
class Shells {
 public:
  explicit Shells(std::size_t count) : above_(count) {
    std::iota(above_.begin(), above_.end(), 0u);
  }

  std::uint32_t first_of(std::uint32_t element) {
    while (above_[element] != element) {
      element = above_[element] = above_[above_[element]];
    }
    return element;
  }

  void join(std::uint32_t u, std::uint32_t v) {
    const std::uint32_t first_u = first_of(u);
    const std::uint32_t first_v = first_of(v);
    above_[std::max(first_u, first_v)] = std::min(first_u, first_v);
  }

 private:
  std::vector<std::uint32_t> above_;
};

/// True if triangles run along each edge equally often in both directions. O(n log n).
bool is_closed(const std::vector<TriangleCorners>& triangles);

/// For each vertex, the first one that triangles connect it to.
std::vector<std::uint32_t> shells_of(const std::vector<TriangleCorners>& triangles,
                                     std::size_t vertex_count);

/// O(n log n).
Surface surface_of(const LatticeMesh& mesh);

}  // namespace flashbvh::bake
