// flashbvh's vertices and poses as Eigen's, for FCL and for approximations of meshes.
#pragma once

#include <Eigen/Geometry>

#include "units.hpp"

namespace compare {

inline std::vector<Eigen::Vector3d> points_of(const flashbvh::Mesh& mesh) {
  return vertices_of<double, Eigen::Vector3d>(mesh);
}

inline Eigen::Isometry3d isometry_of(const flashbvh::Pose& pose) {
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      isometry.linear()(row, column) = rotation_of(pose, row, column);
    }
    isometry.translation()[row] = translation_of(pose, row);
  }
  return isometry;
}

}  // namespace compare
