#include "bake/leaf_order.hpp"

#include <algorithm>
#include <utility>

#include "flashbvh/detail/slab.hpp"

namespace flashbvh::bake {
namespace {

using detail::Extent;
using detail::PackedVector;

PackedVector corner(const LatticeMesh& mesh, std::uint32_t vertex) {
  return PackedVector::of(mesh.vertices[vertex]);
}

std::uint64_t square_root(std::uint64_t square) {
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1) {
    if ((root | bit) * (root | bit) <= square) {
      root |= bit;
    }
  }
  return root;
}

/// Of the leaf's triangles along a direction, in 1/256 of a cell; one cell at least.
std::uint64_t thickness(const LatticeMesh& mesh, const std::vector<std::uint32_t>& triangles,
                        const PackedVector& direction) {
  Extent extent = {INT32_MAX, INT32_MIN};
  for (const std::uint32_t triangle : triangles) {
    for (const std::uint32_t vertex : mesh.triangles[triangle]) {
      extent.add(dot(direction, corner(mesh, vertex)));
    }
  }
  const auto length = static_cast<std::uint64_t>(dot(direction, direction));
  const auto between = static_cast<std::uint64_t>(std::int64_t{extent.most} - extent.least);
  return 256 + (between << 16) / square_root(length << 16);
}

/// How much both slabs let through that begin with this corner of this triangle: their thicknesses
/// multiplied. A triangle without area comes last.
std::uint64_t measure(const LatticeMesh& mesh, const std::vector<std::uint32_t>& triangles,
                      const TriangleCorners& corners) {
  const PackedVector p = corner(mesh, corners[0]);
  const PackedVector along = corner(mesh, corners[1]) - p;
  PackedVector normal{};
  PackedVector across{};
  if (!detail::cross_direction(along, corner(mesh, corners[2]) - p, normal) ||
      !detail::cross_direction(along, normal, across)) {
    return UINT64_MAX;
  }
  return thickness(mesh, triangles, normal) * thickness(mesh, triangles, across);
}

TriangleCorners turned_on(const TriangleCorners& corners, std::uint32_t first) {
  return {corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3]};
}

}  // namespace

std::vector<LeafTriangle> leaf_order(const LatticeMesh& mesh,
                                     const std::vector<std::uint32_t>& triangles) {
  std::vector<LeafTriangle> ordered;
  std::uint64_t least = UINT64_MAX;
  std::size_t best = 0;
  for (const std::uint32_t triangle : triangles) {
    const TriangleCorners& corners = mesh.triangles[triangle];
    ordered.push_back({triangle, corners});
    for (std::uint32_t first = 0; first < 3; ++first) {
      const std::uint64_t of_first = measure(mesh, triangles, turned_on(corners, first));
      if (of_first < least) {
        least = of_first;
        best = ordered.size() - 1;
        ordered.back().corners = turned_on(corners, first);
      }
    }
  }
  std::rotate(ordered.begin(), ordered.begin() + static_cast<std::ptrdiff_t>(best),
              ordered.begin() + static_cast<std::ptrdiff_t>(best) + 1);
  return ordered;
}

}  // namespace flashbvh::bake
