#include <fcl/narrowphase/distance.h>

#include "contender.hpp"
#include "fcl_model.hpp"

using flashbvh::PostMesh;

namespace compare {
namespace {

template <class Volume>
class FclRuler : public Ruler {
 public:
  FclRuler(const PostMesh& a, const PostMesh& b)
      : a_(model_of<Volume>(a)), b_(model_of<Volume>(b)) {}

  void set_poses(const std::vector<Placed>& poses) override { poses_ = transforms_of(poses); }

  std::size_t ask_all(Wanted /*wanted*/) override {
    double sum = 0;
    for (const fcl::Transform3d& pose : poses_) {
      sum += ask(pose);
    }
    return static_cast<std::size_t>(sum);
  }

  Length length(std::size_t pose) override {
    const double cells = ask(poses_[pose]) * kCellsOfUnit;
    return {cells, cells};
  }

 private:
  double ask(const fcl::Transform3d& pose) {
    result_.clear();
    fcl::distance(a_.get(), fcl::Transform3d::Identity(), b_.get(), pose, request_, result_);
    return result_.min_distance;
  }

  std::shared_ptr<fcl::BVHModel<Volume>> a_;
  std::shared_ptr<fcl::BVHModel<Volume>> b_;
  Transforms poses_;
  fcl::DistanceRequestd request_{/*enable_nearest_points=*/true};
  fcl::DistanceResultd result_;
};

}  // namespace

std::unique_ptr<Ruler> ruler_of_fcl(const PostMesh& a, const PostMesh& b, Volumes volumes) {
  if (volumes == Volumes::spheres) {
    return std::make_unique<FclRuler<fcl::RSSd>>(a, b);
  }
  return std::make_unique<FclRuler<fcl::OBBRSSd>>(a, b);
}

}  // namespace compare
