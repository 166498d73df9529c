#include <stdexcept>

#include "contender.hpp"
#include "flashbvh/query.hpp"

using namespace flashbvh;

namespace compare {
namespace {

constexpr std::uint32_t kMost = 1u << 16;
PairQuery::Pair found[kMost];

class Flashbvh : public Collider {
 public:
  Flashbvh(const PostMesh& a, const PostMesh& b, PoseMade pose_made)
      : a_(&a), b_(&b), pose_made_(pose_made) {}

  void set_poses(const std::vector<Placed>& poses) override { poses_ = poses; }

  std::size_t ask_all(Wanted wanted) override {
    const std::uint32_t capacity = wanted == Wanted::first ? 1 : kMost;
    std::size_t count = 0;
    for (const Placed& placed : poses_) {
      count +=
          pose_made_ == PoseMade::before ? ask(placed.pose, capacity) : ask(make(placed), capacity);
    }
    return count;
  }

  std::vector<Pair> pairs(std::size_t pose) override {
    const std::uint32_t count = ask(poses_[pose].pose, kMost);
    if (count == kMost) {
      throw std::runtime_error("more pairs than are counted");
    }
    std::vector<Pair> all;
    for (std::uint32_t i = 0; i < count; ++i) {
      all.emplace_back(found[i].a, found[i].b);
    }
    return all;
  }

 private:
  static Pose make(const Placed& placed) {
    const std::int32_t(&t)[3] = placed.cells;
    return placed.pose.is_translation() ? Pose::translated(t[0], t[1], t[2])
                                        : Pose::rigid(placed.rotation.entry, t);
  }

  std::uint32_t ask(const Pose& pose, std::uint32_t capacity) {
    PairQuery query(*a_, *b_, pose);
    return query.run(UINT32_MAX, found, capacity).count;
  }

  const PostMesh* a_;
  const PostMesh* b_;
  PoseMade pose_made_;
  std::vector<Placed> poses_;
};

}  // namespace

std::unique_ptr<Collider> with_flashbvh(const PostMesh& a, const PostMesh& b, PoseMade pose_made) {
  return std::make_unique<Flashbvh>(a, b, pose_made);
}

}  // namespace compare
