// OPCODE as tools/compare/with_opcode.cpp has it: two matrices. Its headers come last, for their
// macros.
#include <vector>

#include "asked_of.hpp"

// clang-format off
#include <ode/common.h>
#include <OPCODE/Opcode.h>
// clang-format on
#undef for
#undef override

using flashbvh::Pose;
using flashbvh::PostMesh;

namespace compare {
namespace {

class Model {
 public:
  explicit Model(const PostMesh& mesh) {
    for (uint32_t i = 0; i < mesh.vertex_count; ++i) {
      float point[3];
      set_vertex(mesh, i, point);
      vertices_.emplace_back(point[0], point[1], point[2]);
    }
    for (uint32_t i = 0; i < mesh.triangle_count; ++i) {
      const auto& corner = mesh.triangles[i].corner;
      triangles_.emplace_back(corner[0], corner[1], corner[2]);
    }
    interface_.SetNbTriangles(mesh.triangle_count);
    interface_.SetNbVertices(mesh.vertex_count);
    interface_.SetPointers(triangles_.data(), vertices_.data());
    interface_.SetSingle(true);
    const Opcode::BuildSettings rules(Opcode::SPLIT_BEST_AXIS | Opcode::SPLIT_SPLATTER_POINTS |
                                      Opcode::SPLIT_GEOM_CENTER);
    model_.Build(Opcode::OPCODECREATE(&interface_, rules, true, false));
  }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const Opcode::Model* model() const { return &model_; }

 private:
  std::vector<IceMaths::Point> vertices_;
  std::vector<IceMaths::IndexedTriangle> triangles_;
  Opcode::MeshInterface interface_;
  Opcode::Model model_;
};

class WithOpcode : public Library {
 public:
  WithOpcode() {
    identity_.Identity();
    collider_.SetTemporalCoherence(false);
  }

  void set_meshes(const PostMesh& a, const PostMesh& b) override {
    delete a_;
    delete b_;
    a_ = new Model(a);
    b_ = new Model(b);
    cache_.Model0 = a_->model();
    cache_.Model1 = b_->model();
  }

  void set_pose(const Pose& pose) override {
    pose_.Identity();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        pose_.m[column][row] = rotation_of(pose, row, column);
      }
      pose_.m[3][row] = translation_of(pose, row);
    }
  }

  uint32_t ask(bool first) override {
    collider_.SetFirstContact(first);
    collider_.Collide(cache_, &identity_, &pose_);
    return collider_.GetNbPairs();
  }

 private:
  Model* a_ = nullptr;
  Model* b_ = nullptr;
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
