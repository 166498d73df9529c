// Where a pose puts the triangles of a mesh, by the definition in lib/docs/design.md and by nothing
// of the library's own arithmetic; and brute force over all pairs of them.
#ifndef FLASHBVH_TESTS_SUPPORT_PLACED_MESH_HPP
#define FLASHBVH_TESTS_SUPPORT_PLACED_MESH_HPP

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "bake/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/triangle.hpp"

namespace flashbvh::test {

/// The quotient, rounded down.
constexpr std::int64_t floor_divide(std::int64_t value, std::int64_t by) {
  return value / by - (value % by < 0 ? 1 : 0);
}

/// Coordinate `axis` of a vertex of B in A's frame: floor(R p + o + 1/2), where R has 22 fraction
/// bits, o has 14 and the sum of products is cut to 14.
inline std::int32_t placed_coordinate(const bake::LatticeMesh& mesh, const Vertex& v,
                                      const Pose& pose, int axis) {
  const std::array<std::int32_t, 3> p = {v.x, v.y, v.z};
  std::int64_t offset = pose.translation(axis) * (std::int64_t{1} << 30) +
                        pose.fraction(axis) * (std::int64_t{1} << 14);
  std::int64_t turned = 0;
  for (int i = 0; i < 3; ++i) {
    const std::int64_t entry = pose.rotation(axis, i);
    offset += entry * mesh.origin[static_cast<std::size_t>(i)];
    turned += floor_divide(entry + 128, 256) * p[static_cast<std::size_t>(i)];
  }
  const std::int64_t sum = floor_divide(turned, 256) + floor_divide(offset + 32768, 65536);
  return static_cast<std::int32_t>(floor_divide(sum + 8192, 16384));
}

inline std::vector<PlacedTriangle> placed_triangles(const bake::LatticeMesh& mesh,
                                                    const Pose& pose) {
  std::vector<PlacedTriangle> placed;
  for (const auto& triangle : mesh.triangles) {
    PlacedTriangle next{};
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
  const std::vector<PlacedTriangle> of_a = placed_triangles(a, Pose::translated(0, 0, 0));
  const std::vector<PlacedTriangle> of_b = placed_triangles(b, pose);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i < of_a.size(); ++i) {
    for (std::uint32_t j = 0; j < of_b.size(); ++j) {
      if (triangles_intersect(of_a[i], of_b[j])) {
        pairs.emplace_back(i, j);
      }
    }
  }
  return pairs;
}

}  // namespace flashbvh::test

#endif
