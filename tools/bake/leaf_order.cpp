#include "bake/leaf_order.hpp"

#include <algorithm>
#include <utility>

#include "bake/length.hpp"
#include "flashbvh/triangle.hpp"

namespace flashbvh::bake {
namespace {

std::int64_t dot(const Point& u, const Point& v) {
  return std::int64_t{u.x} * v.x + std::int64_t{u.y} * v.y + std::int64_t{u.z} * v.z;
}

/// The cross-section of this triangle's two slabs, the product of their thicknesses: less rejects
/// more. Largest for a triangle without area.
std::uint64_t measure(const LatticeMesh& mesh, const std::vector<std::uint32_t>& triangles,
                      std::uint32_t first) {
  const TriangleCorners& corners = mesh.triangles[first];
  LeafDirections directions{};
  if (!get_leaf_directions(
          {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]},
          directions)) {
    return UINT64_MAX;
  }
  return thickness(mesh, triangles, directions.normal) *
         thickness(mesh, triangles, directions.across);
}

}  // namespace

LeafExtent extent_along(const LatticeMesh& mesh, const std::vector<std::uint32_t>& triangles,
                        const Point& direction) {
  LeafExtent extent = {INT64_MAX, INT64_MIN};
  for (const std::uint32_t triangle : triangles) {
    for (const std::uint32_t vertex : mesh.triangles[triangle]) {
      const auto [x, y, z] = mesh.vertices[vertex];
      const std::int64_t along = dot(direction, {x, y, z});
      extent = {std::min(extent.least, along), std::max(extent.most, along)};
    }
  }
  return extent;
}

std::uint64_t thickness(const LatticeMesh& mesh, const std::vector<std::uint32_t>& triangles,
                        const Point& direction) {
  const LeafExtent extent = extent_along(mesh, triangles, direction);
  const auto length = static_cast<std::uint64_t>(dot(direction, direction));
  return 256 +
         (static_cast<std::uint64_t>(extent.most - extent.least) << 16) / square_root(length << 16);
}

std::vector<std::uint32_t> leaf_order(const LatticeMesh& mesh,
                                      std::vector<std::uint32_t> triangles) {
  if (triangles.size() < 2) {
    return triangles;
  }
  std::uint64_t least = UINT64_MAX;
  std::size_t best = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint64_t of_first = measure(mesh, triangles, triangles[i]);
    if (of_first < least) {
      least = of_first;
      best = i;
    }
  }
  const auto first = triangles.begin() + static_cast<std::ptrdiff_t>(best);
  std::rotate(triangles.begin(), first, first + 1);
  return triangles;
}

}  // namespace flashbvh::bake
