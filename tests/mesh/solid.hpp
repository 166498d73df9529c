// The volume that a mesh encloses.
#pragma once

#include "mesh/mesh_builder.hpp"

namespace flashbvh::test {

/// Negative if the mesh is inside out.
inline double volume(const tool::FileMesh& file) {
  double sum = 0;
  for (const auto& [i, j, k] : file.mesh.triangles) {
    const tool::Position& a = file.mesh.vertices[i];
    const tool::Position& b = file.mesh.vertices[j];
    const tool::Position& c = file.mesh.vertices[k];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

}  // namespace flashbvh::test
