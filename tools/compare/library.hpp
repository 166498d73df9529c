// A library on a board: two meshes and their queries, in the order of the poses. Converts vertices
// and poses to the numbers and the unit of the other libraries.
#pragma once

#include <cstdint>
#include <vector>

#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"

namespace compare {

/// The unit of the other libraries' meshes, in cells: a power of two, so every vertex is exact in
/// binary32, and large enough that products of five lengths and areas stay far from its limits.
inline constexpr double kCellsOfUnit = 1024;

/// All vertices in the mesh's frame, in units and binary32.
template <class Vector>
std::vector<Vector> vertices_of(const flashbvh::Mesh& mesh) {
  const auto units = [](std::int32_t cells) { return static_cast<float>(cells / kCellsOfUnit); };
  std::vector<Vector> all;
  for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
    const flashbvh::Vertex& v = mesh.vertices[i];
    all.push_back(
        {units(mesh.origin[0] + v.x), units(mesh.origin[1] + v.y), units(mesh.origin[2] + v.z)});
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

class Library {
 public:
  virtual ~Library() = default;
  /// Frees the last trees and builds new ones from floats. Not counted.
  virtual void set_meshes(const flashbvh::Mesh& a, const flashbvh::Mesh& b) = 0;
  /// Makes the caller's form of the pose, integers or a matrix of floats. Not counted; conversions
  /// within the query are counted.
  virtual void set_pose(const flashbvh::Pose& pose) = 0;
  /// Pairs of triangles that intersect; with `first`, at most one.
  virtual std::uint32_t query(bool first) = 0;
};

Library& opcode();
Library& float_tree();

}  // namespace compare
