// Converts flashbvh's vertices and poses to the numbers and the unit of the other libraries.
#pragma once

#include <cstdint>

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

inline double rotation_of(const flashbvh::Pose& pose, int row, int column) {
  return pose.rotation(row, column) / static_cast<double>(flashbvh::kRotationOne);
}

/// A translation in units.
inline double translation_of(const flashbvh::Pose& pose, int axis) {
  return (pose.translation(axis) + pose.fraction(axis) / 65536.0) / kCellsOfUnit;
}

}  // namespace compare
