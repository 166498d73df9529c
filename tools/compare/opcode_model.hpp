// OPCODE's model of a baked mesh, on the desktop and on boards. Include its headers last, because
// they define the macros `for`, `null` and `override`.
#pragma once

#include <cstdlib>
#include <vector>

#include "units.hpp"

// clang-format off
#include <ode/common.h>
#include <OPCODE/Opcode.h>
// clang-format on
#undef for
#undef override

namespace compare {

/// The triangles are in the order of the baked mesh.
class OpcodeModel {
 public:
  explicit OpcodeModel(const flashbvh::Mesh& mesh)
      : vertices_(vertices_of<float, IceMaths::Point>(mesh)),
        triangles_(corners_of<IceMaths::IndexedTriangle>(mesh)) {
    interface_.SetNbTriangles(mesh.triangle_count);
    interface_.SetNbVertices(mesh.vertex_count);
    interface_.SetPointers(triangles_.data(), vertices_.data());
    interface_.SetSingle(true);
    if (!model_.Build(settings())) {
      std::abort();  // the tree could not be built
    }
  }
  OpcodeModel(const OpcodeModel&) = delete;
  OpcodeModel& operator=(const OpcodeModel&) = delete;

  const Opcode::Model& model() const { return model_; }

 private:
  /// The settings of ODE's dxTriMeshData: an optimised tree without leaves, not quantized.
  Opcode::OPCODECREATE settings() {
    const Opcode::BuildSettings rules(Opcode::SPLIT_BEST_AXIS | Opcode::SPLIT_SPLATTER_POINTS |
                                      Opcode::SPLIT_GEOM_CENTER);
    return Opcode::OPCODECREATE(&interface_, rules, true, false);
  }

  std::vector<IceMaths::Point> vertices_;
  std::vector<IceMaths::IndexedTriangle> triangles_;
  Opcode::MeshInterface interface_;
  Opcode::Model model_;
};

/// For row vectors.
inline IceMaths::Matrix4x4 matrix_of(const flashbvh::Pose& pose) {
  IceMaths::Matrix4x4 matrix;
  matrix.Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      matrix.m[column][row] = static_cast<float>(rotation_of(pose, row, column));
    }
    matrix.m[3][row] = static_cast<float>(translation_of(pose, row));
  }
  return matrix;
}

}  // namespace compare
