// OPCODE with two matrices, as in tools/compare/with_opcode.cpp.
#include <memory>

#include "library.hpp"
//
#include "opcode_model.hpp"

using flashbvh::Mesh;
using flashbvh::Pose;

namespace compare {
namespace {

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
