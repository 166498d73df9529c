#include "opcode_model.hpp"

using flashbvh::PostMesh;

namespace compare {
namespace {

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
  OpcodeModel a_;
  OpcodeModel b_;
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
