#include <fcl/narrowphase/collision.h>

#include <limits>

#include "contender.hpp"
#include "fcl_model.hpp"

using flashbvh::PostMesh;

namespace compare {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

class Fcl : public Collider {
 public:
  Fcl(const PostMesh& a, const PostMesh& b)
      : mesh_a_(&a), mesh_b_(&b), a_(model_of<fcl::OBBRSSd>(a)), b_(model_of<fcl::OBBRSSd>(b)) {}

  void set_poses(const std::vector<Placed>& poses) override { poses_ = transforms_of(poses); }

  std::size_t ask_all(Wanted wanted) override {
    std::size_t count = 0;
    for (const fcl::Transform3d& pose : poses_) {
      count += ask(pose, wanted);
    }
    return count;
  }

  std::vector<Pair> pairs(std::size_t pose) override {
    std::vector<Pair> all;
    for (std::size_t i = 0, count = ask(poses_[pose], Wanted::all); i < count; ++i) {
      const fcl::Contactd& contact = result_.getContact(i);
      all.emplace_back(mesh_a_->triangle_ids[contact.b1], mesh_b_->triangle_ids[contact.b2]);
    }
    return all;
  }

 private:
  std::size_t ask(const fcl::Transform3d& pose, Wanted wanted) {
    const fcl::CollisionRequestd request(
        wanted == Wanted::first ? 1 : std::numeric_limits<std::size_t>::max());
    result_.clear();
    fcl::collide(a_.get(), fcl::Transform3d::Identity(), b_.get(), pose, request, result_);
    return result_.numContacts();
  }

  const PostMesh* mesh_a_;
  const PostMesh* mesh_b_;
  std::shared_ptr<Model> a_;
  std::shared_ptr<Model> b_;
  Transforms poses_;
  fcl::CollisionResultd result_;
};

}  // namespace

std::unique_ptr<Collider> with_fcl(const PostMesh& a, const PostMesh& b) {
  return std::make_unique<Fcl>(a, b);
}

}  // namespace compare
