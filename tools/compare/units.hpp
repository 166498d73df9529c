// Converts flashbvh's vertices and poses to the numbers and the unit of the other libraries.
#pragma once

#include <cstdint>
#include <vector>

#include "flashbvh/lattice.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"

namespace compare {

/// The unit of the other libraries' meshes, in cells: a power of two, so every vertex is exact in
/// binary32, and large enough that products of five lengths and areas stay far from its limits.
inline constexpr double kCellsOfUnit = 1024;

/// A vertex in the mesh's frame, in units.
template <class Number>
void set_vertex(const flashbvh::Mesh& mesh, std::uint32_t vertex, Number (&point)[3]) {
  const flashbvh::Vertex& v = mesh.vertices[vertex];
  const std::int32_t cells[3] = {v.x, v.y, v.z};
  for (int axis = 0; axis < 3; ++axis) {
    point[axis] = static_cast<Number>((mesh.origin[axis] + cells[axis]) / kCellsOfUnit);
  }
}

/// A point of binary32, in units.
template <class Vector>
Vector in_units(const flashbvh::Point& point) {
  const auto units = [](std::int32_t cells) { return static_cast<float>(cells / kCellsOfUnit); };
  return {units(point.x), units(point.y), units(point.z)};
}

/// All vertices in the mesh's frame, in units.
template <class Number, class Vector>
std::vector<Vector> vertices_of(const flashbvh::Mesh& mesh) {
  std::vector<Vector> all;
  for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
    Number point[3];
    set_vertex(mesh, i, point);
    all.push_back({point[0], point[1], point[2]});
  }
  return all;
}

/// The corners of all triangles, in the order of the baked mesh.
template <class Corners>
std::vector<Corners> corners_of(const flashbvh::Mesh& mesh) {
  std::vector<Corners> all;
  for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
    const auto& corner = mesh.triangles[i].corner;
    all.push_back({corner[0], corner[1], corner[2]});
  }
  return all;
}

inline double rotation_of(const flashbvh::Pose& pose, int row, int column) {
  return pose.rotation(row, column) / static_cast<double>(flashbvh::kRotationOne);
}

/// A translation in units.
inline double translation_of(const flashbvh::Pose& pose, int axis) {
  return (pose.translation(axis) + pose.fraction(axis) / 65536.0) / kCellsOfUnit;
}

}  // namespace compare
