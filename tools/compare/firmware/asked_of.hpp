// A library on a board: two meshes, queries about them, in the order of the poses.
#ifndef FLASHBVH_TOOLS_COMPARE_FIRMWARE_ASKED_OF_HPP
#define FLASHBVH_TOOLS_COMPARE_FIRMWARE_ASKED_OF_HPP

#include <stdint.h>

#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"

namespace compare {

/// The unit of the libraries in floats, in cells: every vertex is exact in binary32.
constexpr float kCellsOfUnit = 1024;

inline float rotation_of(const flashbvh::Pose& pose, int row, int column) {
  return static_cast<float>(pose.rotation(row, column)) /
         static_cast<float>(flashbvh::kRotationOne);
}

inline float translation_of(const flashbvh::Pose& pose, int axis) {
  return static_cast<float>(pose.translation(axis)) / kCellsOfUnit;
}

inline void set_vertex(const flashbvh::PostMesh& mesh, uint32_t vertex, float (&point)[3]) {
  const flashbvh::Vertex& v = mesh.vertices[vertex];
  const int32_t cells[3] = {v.x, v.y, v.z};
  for (int axis = 0; axis < 3; ++axis) {
    point[axis] = static_cast<float>(mesh.origin[axis] + cells[axis]) / kCellsOfUnit;
  }
}

class Library {
 public:
  virtual ~Library() = default;
  /// Not counted: trees are built here, of floats, and what was built before is freed.
  virtual void set_meshes(const flashbvh::PostMesh& a, const flashbvh::PostMesh& b) = 0;
  /// Not counted: the pose is put into the caller's form, integers or a matrix of floats. What a
  /// query makes of it is.
  virtual void set_pose(const flashbvh::Pose& pose) = 0;
  /// Pairs of triangles that intersect; with `first`, at most one.
  virtual uint32_t ask(bool first) = 0;
};

Library& opcode();
Library& float_tree();

}  // namespace compare

#endif
