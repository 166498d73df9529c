#include "contender.hpp"
#include "flashbvh/clearance.hpp"

using namespace flashbvh;

namespace compare {
namespace {

/// How far B came since the pose before, in cells: tests/figures/clearance.cpp has the same.
constexpr std::int32_t kStep = 10;

/// B as it was one step before.
Pose last_pose(const Placed& placed) {
  const std::int32_t cells[3] = {placed.cells[0] + kStep, placed.cells[1], placed.cells[2]};
  return placed.pose.is_translation() ? Pose::translated(cells[0], cells[1], cells[2])
                                      : Pose::rigid(placed.rotation.entry, cells);
}

class FlashbvhRuler : public Ruler {
 public:
  FlashbvhRuler(const PostMesh& a, const PostMesh& b, Seeds seeds)
      : a_(&a), b_(&b), seeds_(seeds) {}

  void set_poses(const std::vector<Placed>& poses) override {
    asked_.clear();
    for (const Placed& placed : poses) {
      Witness<std::uint16_t> seed;
      if (seeds_ == Seeds::last_pose) {
        seed = distance(*a_, *b_, last_pose(placed)).witness;
      }
      asked_.push_back({placed.pose, seed});
    }
  }

  std::size_t ask_all(Wanted /*wanted*/) override {
    std::size_t sum = 0;
    for (const Asked& asked : asked_) {
      sum += distance(*a_, *b_, asked.pose, asked.seed).lower;
    }
    return sum;
  }

  Length length(std::size_t pose) override {
    const Asked& asked = asked_[pose];
    const auto known = distance(*a_, *b_, asked.pose, asked.seed);
    return {known.lower / 256.0, known.upper / 256.0};
  }

 private:
  struct Asked {
    Pose pose;
    Witness<std::uint16_t> seed;
  };

  const PostMesh* a_;
  const PostMesh* b_;
  Seeds seeds_;
  std::vector<Asked> asked_;
};

}  // namespace

std::unique_ptr<Ruler> ruler_of_flashbvh(const PostMesh& a, const PostMesh& b, Seeds seeds) {
  return std::make_unique<FlashbvhRuler>(a, b, seeds);
}

}  // namespace compare
