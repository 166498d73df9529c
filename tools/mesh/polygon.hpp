// Cuts polygons into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace flashbvh::tool {

/// Cuts a polygon of n >= 3 corners into exactly n - 2 triangles by cutting off ears; a convex one
/// becomes a fan from its first corner. Corners are the indices 0 to n - 1. Also cuts polygons that
/// cross themselves or have no area. O(n^2), O(n^3) where a round of the corners finds few ears.
///
/// assimp's triangulation omits triangles of less than 1e-5 square units.
std::vector<std::array<std::uint32_t, 3>> triangulate(
    const std::vector<std::array<double, 3>>& corners);

}  // namespace flashbvh::tool
