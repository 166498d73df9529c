// A baked mesh for Bullet, with its triangles in the order of the baked mesh.
#pragma once

#include <btBulletCollisionCommon.h>

#include <array>
#include <vector>

#include "units.hpp"

namespace compare {

/// The arrays that Bullet's shapes refer to without copying.
class BulletMesh {
 public:
  explicit BulletMesh(const flashbvh::Mesh& mesh)
      : vertices_(vertices_of<float, std::array<float, 3>>(mesh)),
        corners_(corners_of<std::array<int, 3>>(mesh)) {
    btIndexedMesh indexed;
    indexed.m_numTriangles = static_cast<int>(mesh.triangle_count);
    indexed.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(corners_.data());
    indexed.m_triangleIndexStride = sizeof corners_[0];
    indexed.m_numVertices = static_cast<int>(mesh.vertex_count);
    indexed.m_vertexBase = reinterpret_cast<const unsigned char*>(vertices_.data());
    indexed.m_vertexStride = sizeof vertices_[0];
    array_.addIndexedMesh(indexed);
  }
  BulletMesh(const BulletMesh&) = delete;
  BulletMesh& operator=(const BulletMesh&) = delete;

  btTriangleIndexVertexArray& array() { return array_; }

 private:
  std::vector<std::array<float, 3>> vertices_;
  std::vector<std::array<int, 3>> corners_;
  btTriangleIndexVertexArray array_;
};

inline btTransform transform_of(const flashbvh::Pose& pose) {
  btTransform transform;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      transform.getBasis()[row][column] = static_cast<float>(rotation_of(pose, row, column));
    }
    transform.getOrigin()[row] = static_cast<float>(translation_of(pose, row));
  }
  return transform;
}

}  // namespace compare
