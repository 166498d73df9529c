// Its headers come last, for their macros: `for`, `null`, `override`.
#include <stdexcept>

#include "contender.hpp"
#include "meshes.hpp"

// clang-format off
#include <ode/common.h>
#include <OPCODE/Opcode.h>
// clang-format on
#undef for
#undef override

using flashbvh::PostMesh;

namespace compare {
namespace {

/// Its triangles in the order of the baked mesh.
class Model {
 public:
  explicit Model(const PostMesh& mesh) {
    for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
      float point[3];
      set_vertex(mesh, i, point);
      vertices_.emplace_back(point[0], point[1], point[2]);
    }
    for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
      const auto& corner = mesh.triangles[i].corner;
      triangles_.emplace_back(corner[0], corner[1], corner[2]);
    }
    interface_.SetNbTriangles(mesh.triangle_count);
    interface_.SetNbVertices(mesh.vertex_count);
    interface_.SetPointers(triangles_.data(), vertices_.data());
    interface_.SetSingle(true);
    if (!model_.Build(settings())) {
      throw std::runtime_error("OPCODE could not build a tree");
    }
  }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const Opcode::Model& model() const { return model_; }

 private:
  /// As in ODE's dxTriMeshData: an optimised tree without leaves, not quantized.
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

class WithOpcode : public Collider {
 public:
  WithOpcode(const PostMesh& a, const PostMesh& b, Matrices matrices)
      : mesh_a_(&a), mesh_b_(&b), a_(a), b_(b) {
    cache_.Model0 = &a_.model();
    cache_.Model1 = &b_.model();
    identity_.Identity();
    matrix_a_ = matrices == Matrices::both ? &identity_ : nullptr;
    collider_.SetTemporalCoherence(false);
  }

  void set_poses(const std::vector<Placed>& poses) override {
    poses_.clear();
    for (const Placed& placed : poses) {
      IceMaths::Matrix4x4 matrix;  // of row vectors
      matrix.Identity();
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
          matrix.m[column][row] = static_cast<float>(rotation_of(placed.pose, row, column));
        }
        matrix.m[3][row] = static_cast<float>(translation_of(placed.pose, row));
      }
      poses_.push_back(matrix);
    }
  }

  std::size_t ask_all(Wanted wanted) override {
    collider_.SetFirstContact(wanted == Wanted::first);
    std::size_t count = 0;
    for (const IceMaths::Matrix4x4& pose : poses_) {
      collider_.Collide(cache_, matrix_a_, &pose);
      count += collider_.GetNbPairs();
    }
    return count;
  }

  std::vector<Pair> pairs(std::size_t pose) override {
    collider_.SetFirstContact(false);
    if (!collider_.Collide(cache_, matrix_a_, &poses_[pose])) {
      throw std::runtime_error("OPCODE refused a query");
    }
    std::vector<Pair> all;
    for (std::uint32_t i = 0; i < collider_.GetNbPairs(); ++i) {
      const IceCore::Pair& pair = collider_.GetPairs()[i];
      all.emplace_back(mesh_a_->triangle_ids[pair.id0], mesh_b_->triangle_ids[pair.id1]);
    }
    return all;
  }

 private:
  const PostMesh* mesh_a_;
  const PostMesh* mesh_b_;
  Model a_;
  Model b_;
  Opcode::BVTCache cache_;
  Opcode::AABBTreeCollider collider_;
  IceMaths::Matrix4x4 identity_;
  const IceMaths::Matrix4x4* matrix_a_;
  std::vector<IceMaths::Matrix4x4> poses_;
};

}  // namespace

std::unique_ptr<Collider> with_opcode(const PostMesh& a, const PostMesh& b, Matrices matrices) {
  return std::make_unique<WithOpcode>(a, b, matrices);
}

}  // namespace compare
