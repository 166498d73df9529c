// Baked meshes and their poses as FCL takes them.
#ifndef FLASHBVH_TOOLS_COMPARE_FCL_MODEL_HPP
#define FLASHBVH_TOOLS_COMPARE_FCL_MODEL_HPP

#include <fcl/geometry/bvh/BVH_model.h>

#include <memory>
#include <vector>

#include "contender.hpp"
#include "meshes.hpp"

namespace compare {

/// Its triangles in the order of the baked mesh.
template <class Volume>
std::shared_ptr<fcl::BVHModel<Volume>> model_of(const flashbvh::PostMesh& mesh) {
  std::vector<fcl::Vector3d> vertices;
  for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
    double point[3];
    set_vertex(mesh, i, point);
    vertices.emplace_back(point[0], point[1], point[2]);
  }
  std::vector<fcl::Triangle> triangles;
  for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
    const auto& corner = mesh.triangles[i].corner;
    triangles.emplace_back(corner[0], corner[1], corner[2]);
  }
  auto model = std::make_shared<fcl::BVHModel<Volume>>();
  model->beginModel();
  model->addSubModel(vertices, triangles);
  model->endModel();
  return model;
}

using Transforms = std::vector<fcl::Transform3d, Eigen::aligned_allocator<fcl::Transform3d>>;

inline Transforms transforms_of(const std::vector<Placed>& poses) {
  Transforms transforms;
  for (const Placed& placed : poses) {
    fcl::Transform3d transform = fcl::Transform3d::Identity();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        transform.linear()(row, column) = rotation_of(placed.pose, row, column);
      }
      transform.translation()[row] = translation_of(placed.pose, row);
    }
    transforms.push_back(transform);
  }
  return transforms;
}

}  // namespace compare

#endif
