// The triangles of a mesh where a pose puts them, and brute force over all pairs of them.
#ifndef FLASHBVH_TESTS_SUPPORT_PLACED_MESH_HPP
#define FLASHBVH_TESTS_SUPPORT_PLACED_MESH_HPP

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "bake/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/detail/triangle.hpp"
#include "support/placed_vertex.hpp"

namespace flashbvh::test {

/// Coordinate `axis` of a vertex of B in A's frame.
inline std::int32_t placed_coordinate(const bake::LatticeMesh& mesh, const Vertex& v,
                                      const Pose& pose, int axis) {
  const std::int32_t origin[3] = {mesh.origin[0], mesh.origin[1], mesh.origin[2]};
  return placed_coordinate(origin, v, pose, axis);
}

inline std::vector<Triangle> placed_triangles(const bake::LatticeMesh& mesh,
                                                    const Pose& pose) {
  std::vector<Triangle> placed;
  for (const auto& triangle : mesh.triangles) {
    Triangle next{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex& v = mesh.vertices[triangle[i]];
      next.corner[i] = {placed_coordinate(mesh, v, pose, 0), placed_coordinate(mesh, v, pose, 1),
                        placed_coordinate(mesh, v, pose, 2)};
    }
    placed.push_back(next);
  }
  return placed;
}

/// All pairs of triangles that meet, in order.
inline std::vector<std::pair<std::uint32_t, std::uint32_t>> brute_force(const bake::LatticeMesh& a,
                                                                        const bake::LatticeMesh& b,
                                                                        const Pose& pose) {
  const std::vector<Triangle> of_a = placed_triangles(a, Pose::translated(0, 0, 0));
  const std::vector<Triangle> of_b = placed_triangles(b, pose);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i < of_a.size(); ++i) {
    for (std::uint32_t j = 0; j < of_b.size(); ++j) {
      if (detail::triangles_intersect(of_a[i], of_b[j])) {
        pairs.emplace_back(i, j);
      }
    }
  }
  return pairs;
}

}  // namespace flashbvh::test

#endif
