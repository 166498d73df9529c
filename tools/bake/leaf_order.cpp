#include "bake/leaf_order.hpp"

#include <algorithm>
#include <utility>

#include "flashbvh/detail/bounds/slab.hpp"

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
  const std::int32_t first = dot(direction, corner(mesh, mesh.triangles[triangles[0]][0]));
  Extent extent = {first, first};
  for (const std::uint32_t triangle : triangles) {
    for (const std::uint32_t vertex : mesh.triangles[triangle]) {
      extent.add(dot(direction, corner(mesh, vertex)));
    }
  }
  const auto length = static_cast<std::uint64_t>(dot(direction, direction));
  const auto between = static_cast<std::uint64_t>(std::int64_t{extent.most} - extent.least);
  return 256 + (between << 16) / square_root(length << 16);
}

/// How much the slabs of this triangle let through: their thicknesses multiplied. One without area
/// comes last.
std::uint64_t measure(const LatticeMesh& mesh, const std::vector<std::uint32_t>& triangles,
                      std::uint32_t first) {
  const TriangleCorners& corners = mesh.triangles[first];
  const detail::PackedTriangle triangle = {corner(mesh, corners[0]), corner(mesh, corners[1]),
                                           corner(mesh, corners[2])};
  PackedVector normal{};
  PackedVector across{};
  if (!triangle.plane_direction(normal) || !triangle.edge_direction(normal, across)) {
    return UINT64_MAX;
  }
  return thickness(mesh, triangles, normal) * thickness(mesh, triangles, across);
}

}  // namespace

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
