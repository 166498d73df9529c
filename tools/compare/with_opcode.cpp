// OPCODE with two matrices.
#include <cstdlib>
#include <memory>
#include <vector>

#include "library.hpp"
// OPCODE's headers come last, because they define the macros `for`, `null` and `override`.
// clang-format off
#include <ode/common.h>
#include <OPCODE/Opcode.h>
// clang-format on
#undef for
#undef override

using flashbvh::Mesh;
using flashbvh::Pose;

namespace compare {
namespace {

/// The triangles are in the order of the baked mesh.
class OpcodeModel {
 public:
  explicit OpcodeModel(const Mesh& mesh)
      : vertices_(vertices_of<IceMaths::Point>(mesh)),
        triangles_(corners_of<IceMaths::IndexedTriangle>(mesh)) {
    interface_.SetNbTriangles(mesh.triangle_count);
    interface_.SetNbVertices(mesh.vertex_count);
    interface_.SetPointers(triangles_.data(), vertices_.data());
    interface_.SetSingle(true);
    // The settings of ODE's dxTriMeshData: an optimised tree without leaves, not quantized.
    const Opcode::BuildSettings rules(Opcode::SPLIT_BEST_AXIS | Opcode::SPLIT_SPLATTER_POINTS |
                                      Opcode::SPLIT_GEOM_CENTER);
    if (!model_.Build(Opcode::OPCODECREATE(&interface_, rules, true, false))) {
      std::abort();  // the tree could not be built
    }
  }
  OpcodeModel(const OpcodeModel&) = delete;
  OpcodeModel& operator=(const OpcodeModel&) = delete;

  const Opcode::Model& model() const { return model_; }

 private:
  std::vector<IceMaths::Point> vertices_;
  std::vector<IceMaths::IndexedTriangle> triangles_;
  Opcode::MeshInterface interface_;
  Opcode::Model model_;
};

/// For row vectors.
IceMaths::Matrix4x4 matrix_of(const Pose& pose) {
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

class WithOpcode : public Library {
 public:
  WithOpcode() {
    identity_.Identity();
    collider_.SetTemporalCoherence(false);
  }

  void set_meshes(const Mesh& a, const Mesh& b) override {
    a_ = std::make_unique<OpcodeModel>(a);
    b_ = std::make_unique<OpcodeModel>(b);
    cache_.Model0 = &a_->model();
    cache_.Model1 = &b_->model();
  }

  void set_pose(const Pose& pose) override { pose_ = matrix_of(pose); }

  uint32_t query(bool first) override {
    collider_.SetFirstContact(first);
    collider_.Collide(cache_, &identity_, &pose_);
    return collider_.GetNbPairs();
  }

 private:
  std::unique_ptr<OpcodeModel> a_;
  std::unique_ptr<OpcodeModel> b_;
  Opcode::BVTCache cache_;
  Opcode::AABBTreeCollider collider_;
  IceMaths::Matrix4x4 identity_;
  IceMaths::Matrix4x4 pose_;
};

}  // namespace

Library& opcode() {
  static WithOpcode* const library = new WithOpcode;
  return *library;
}

}  // namespace compare
