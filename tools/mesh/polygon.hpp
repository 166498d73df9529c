// Cuts polygons into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace flashbvh::tool {

/// Cuts a polygon of n >= 3 corners into exactly n - 2 triangles by cutting off ears; a convex one
/// becomes a fan from its first corner. Corners are the indices 0 to n - 1. Also cuts polygons that
/// cross themselves or have no area. O(n^2).
///
/// assimp's triangulation omits triangles of less than 1e-5 square units.
std::vector<std::array<std::uint32_t, 3>> triangulate(
    const std::vector<std::array<double, 3>>& corners);

using Corner2 = std::array<double, 2>;

/// Twice the area of a triangle, positive if it runs counter-clockwise.
inline double turn(const Corner2& p, const Corner2& q, const Corner2& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

}  // namespace flashbvh::tool
