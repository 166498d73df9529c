#include "comparison.hpp"
//
#include "opcode_model.hpp"
//
#include <cmath>
#include <stdexcept>

using flashbvh::Mesh;

namespace compare {
namespace {

class WithOpcode : public Collider {
 public:
  WithOpcode(const Mesh& a, const Mesh& b, Matrices matrices)
      : mesh_a_(&a), mesh_b_(&b), a_(a), b_(b) {
    cache_.Model0 = &a_.model();
    cache_.Model1 = &b_.model();
    identity_.Identity();
    matrix_a_ = matrices == Matrices::both ? &identity_ : nullptr;
    collider_.SetTemporalCoherence(false);
  }

  void set_poses(const std::vector<Placed>& poses) override {
    poses_ = converted(poses, matrix_of);
  }

  std::size_t query_all(Wanted wanted) override {
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
  const Mesh* mesh_a_;
  const Mesh* mesh_b_;
  OpcodeModel a_;
  OpcodeModel b_;
  Opcode::BVTCache cache_;
  Opcode::AABBTreeCollider collider_;
  IceMaths::Matrix4x4 identity_;
  const IceMaths::Matrix4x4* matrix_a_;
  std::vector<IceMaths::Matrix4x4> poses_;
};

class OpcodeRayCaster : public RayCaster {
 public:
  explicit OpcodeRayCaster(const Mesh& mesh) : model_(mesh) {
    collider_.SetClosestHit(true);
    collider_.SetCulling(false);
    collider_.SetTemporalCoherence(false);
    collider_.SetDestination(&faces_);
  }

  double nearest(const flashbvh::Segment& segment) override {
    const IceMaths::Point from = in_units<IceMaths::Point>(segment.from);
    IceMaths::Point way = in_units<IceMaths::Point>(segment.to) - from;
    const float length = way.Magnitude();
    way /= length;
    collider_.SetMaxDist(length);
    faces_.Reset();
    if (!collider_.Collide(IceMaths::Ray(from, way), model_.model())) {
      throw std::runtime_error("OPCODE refused a ray");
    }
    double nearest = kNoHit;
    for (udword i = 0; i < faces_.GetNbFaces(); ++i) {
      nearest = std::fmin(nearest, faces_.GetFaces()[i].mDistance / length);
    }
    return nearest;
  }

 private:
  OpcodeModel model_;
  Opcode::RayCollider collider_;
  Opcode::CollisionFaces faces_;
};

}  // namespace

std::unique_ptr<Collider> with_opcode(const Mesh& a, const Mesh& b, Matrices matrices) {
  return std::make_unique<WithOpcode>(a, b, matrices);
}

std::unique_ptr<RayCaster> ray_caster_of_opcode(const Mesh& mesh) {
  return std::make_unique<OpcodeRayCaster>(mesh);
}

}  // namespace compare
