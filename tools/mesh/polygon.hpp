// From polygons to triangles.
#ifndef FLASHBVH_TOOLS_MESH_POLYGON_HPP
#define FLASHBVH_TOOLS_MESH_POLYGON_HPP

#include <array>
#include <cstdint>
#include <vector>

namespace flashbvh::tool {

/// Cuts a polygon of n >= 3 corners into exactly n - 2 triangles by cutting off ears, a convex one
/// into a fan from its first corner. Corners are the indices 0 to n - 1. A polygon that crosses
/// itself or has no area is cut all the same. O(n log n) for most polygons, O(n^1.5) where many
/// corners lie near long edges, as in a star of many rays; O(n^2) at worst.
///
/// assimp's own way leaves out triangles of less than 1e-5 square units.
std::vector<std::array<std::uint32_t, 3>> triangulate(
    const std::vector<std::array<double, 3>>& corners);

}  // namespace flashbvh::tool

#endif
