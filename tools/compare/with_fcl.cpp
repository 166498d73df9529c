#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <limits>

#include "comparison.hpp"
#include "eigen_mesh.hpp"

using flashbvh::Mesh;

namespace compare {
namespace {

/// The model's triangles are in the order of the baked mesh.
template <class Volume>
std::shared_ptr<fcl::BVHModel<Volume>> model_of(const Mesh& mesh) {
  auto model = std::make_shared<fcl::BVHModel<Volume>>();
  model->beginModel();
  model->addSubModel(points_of(mesh), corners_of<fcl::Triangle>(mesh));
  model->endModel();
  return model;
}

class Fcl : public Collider {
 public:
  Fcl(const Mesh& a, const Mesh& b)
      : mesh_a_(&a), mesh_b_(&b), a_(model_of<fcl::OBBRSSd>(a)), b_(model_of<fcl::OBBRSSd>(b)) {}

  void set_poses(const std::vector<Placed>& poses) override {
    poses_ = converted(poses, isometry_of);
  }

  std::size_t query_all(Wanted wanted) override {
    std::size_t count = 0;
    for (const fcl::Transform3d& pose : poses_) {
      count += query(pose, wanted);
    }
    return count;
  }

  std::vector<Pair> pairs(std::size_t pose) override {
    std::vector<Pair> all;
    for (std::size_t i = 0, count = query(poses_[pose], Wanted::all); i < count; ++i) {
      const fcl::Contactd& contact = result_.getContact(i);
      all.emplace_back(mesh_a_->triangle_ids[contact.b1], mesh_b_->triangle_ids[contact.b2]);
    }
    return all;
  }

 private:
  std::size_t query(const fcl::Transform3d& pose, Wanted wanted) {
    const fcl::CollisionRequestd request(
        wanted == Wanted::first ? 1 : std::numeric_limits<std::size_t>::max());
    result_.clear();
    fcl::collide(a_.get(), fcl::Transform3d::Identity(), b_.get(), pose, request, result_);
    return result_.numContacts();
  }

  const Mesh* mesh_a_;
  const Mesh* mesh_b_;
  std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> a_;
  std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> b_;
  std::vector<fcl::Transform3d> poses_;
  fcl::CollisionResultd result_;
};

template <class Volume>
class FclDistances : public DistanceMeter {
 public:
  FclDistances(const Mesh& a, const Mesh& b) : a_(model_of<Volume>(a)), b_(model_of<Volume>(b)) {}

  void set_poses(const std::vector<Placed>& poses) override {
    poses_ = converted(poses, isometry_of);
  }

  std::size_t query_all(Wanted /*wanted*/) override {
    double sum = 0;
    for (const fcl::Transform3d& pose : poses_) {
      sum += query(pose);
    }
    return static_cast<std::size_t>(sum);
  }

  Length length(std::size_t pose) override {
    const double cells = query(poses_[pose]) * kCellsOfUnit;
    return {cells, cells};
  }

 private:
  double query(const fcl::Transform3d& pose) {
    result_.clear();
    fcl::distance(a_.get(), fcl::Transform3d::Identity(), b_.get(), pose, request_, result_);
    return result_.min_distance;
  }

  std::shared_ptr<fcl::BVHModel<Volume>> a_;
  std::shared_ptr<fcl::BVHModel<Volume>> b_;
  std::vector<fcl::Transform3d> poses_;
  fcl::DistanceRequestd request_{/*enable_nearest_points=*/true};
  fcl::DistanceResultd result_;
};

}  // namespace

std::unique_ptr<Collider> with_fcl(const Mesh& a, const Mesh& b) {
  return std::make_unique<Fcl>(a, b);
}

std::unique_ptr<DistanceMeter> distances_of_fcl(const Mesh& a, const Mesh& b, Volumes volumes) {
  if (volumes == Volumes::spheres) {
    return std::make_unique<FclDistances<fcl::RSSd>>(a, b);
  }
  return std::make_unique<FclDistances<fcl::OBBRSSd>>(a, b);
}

}  // namespace compare
