// A baked mesh for Bullet, with its triangles in the order of the baked mesh.
#pragma once

#include <btBulletCollisionCommon.h>

#include <vector>

#include "units.hpp"

namespace compare {

/// The arrays that Bullet's shapes refer to without copying.
class BulletMesh {
 public:
  explicit BulletMesh(const flashbvh::Mesh& mesh) {
    for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
      float point[3];
      set_vertex(mesh, i, point);
      vertices_.insert(vertices_.end(), point, point + 3);
    }
    for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
      const auto& corner = mesh.triangles[i].corner;
      corners_.insert(corners_.end(), corner, corner + 3);
    }
    btIndexedMesh indexed;
    indexed.m_numTriangles = static_cast<int>(mesh.triangle_count);
    indexed.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(corners_.data());
    indexed.m_triangleIndexStride = 3 * sizeof(int);
    indexed.m_numVertices = static_cast<int>(mesh.vertex_count);
    indexed.m_vertexBase = reinterpret_cast<const unsigned char*>(vertices_.data());
    indexed.m_vertexStride = 3 * sizeof(float);
    array_.addIndexedMesh(indexed);
  }
  BulletMesh(const BulletMesh&) = delete;
  BulletMesh& operator=(const BulletMesh&) = delete;

  btTriangleIndexVertexArray& array() { return array_; }
  const std::vector<float>& vertices() const { return vertices_; }

 private:
  std::vector<float> vertices_;
  std::vector<int> corners_;
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
