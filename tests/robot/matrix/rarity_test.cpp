// Shares of configurations that collide, against exact quotients.
#include "robot/matrix/rarity.hpp"
#include "flashbvh/collide.hpp"
#include "support/arms/arms.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

constexpr double kCell = 1e-4;
constexpr std::uint32_t kSamples = 4000;

/// A block that slides from -1 to 1 past a pin at 0; together they are 2 * `reach` wide.
Model sliding(double reach) {
  Model model;
  add_link(model, kNoJoint, box({-reach / 2, 0, 0}, {reach / 2, 0.1, 0.1}));
  const std::size_t joint =
      add_joint(model, kNoJoint, turned(1, kPi / 2), JointType::prismatic, -1, 1);
  add_link(model, joint, box({-0.05, 0.05, -reach / 2}, {0.15, 0.2, reach / 2}));
  return model;
}

Collisions collisions(const Model& model, const std::vector<PairVerdict>& pairs) {
  const BakedArm arm(model, kCell);
  return collisions_of(model, arm.wholes().data(), kCell, pairs, kSamples)[0];
}

const std::vector<PairVerdict> kCan = {{0, 1, MatrixVerdict::can, "", {0}, 0}};

}  // namespace

TEST_CASE("the share of configurations that collide is reported, of rare ones from more") {
  for (const auto& [reach, of] :
       {std::pair(0.5, kSamples), {0.1, kSamples}, {0.001, 10 * kSamples}}) {
    CAPTURE(reach);
    const Collisions found = collisions(sliding(reach), kCan);
    CHECK(found.of == of);
    // Within five standard deviations, and a cell on either side.
    CHECK(std::abs(found.count - reach * of) <= 5 * std::sqrt(reach * of) + kCell * of);
    CHECK_FALSE(share_of(found).is_bound);
    CHECK(share_of(found).part * of == Approx(found.count));
  }
  // Pairs with other verdicts are not sampled.
  CHECK(collisions(sliding(0.5), {{0, 1, MatrixVerdict::never, "", {}, 0}}).of == 0);
}

TEST_CASE("what no sample finds is bounded, and it is reported how likely it is missed") {
  const Share none = share_of({0, 20000});
  CHECK(none.is_bound);
  CHECK(std::pow(1 - none.part, 20000) == Approx(0.05));
  CHECK(missed_by(10000, none) == Approx(std::sqrt(0.05)));
  CHECK(missed_by(10000, share_of({1, 10000})) == Approx(std::exp(-1)).epsilon(1e-3));
  CHECK(missed_by(10000, share_of({10000, 10000})) == 0);
}

TEST_CASE("the triangles of a witness are two that intersect there") {
  const Model model = sliding(0.3);
  const BakedArm arm(model, kCell);
  const auto lit =
      triangles_at(model, arm.wholes().data(), kCell, {0, 1, MatrixVerdict::can, "", {0.1}, 0});
  const Pose pose = pose_of(frame_between(model, joints_between(model, 0, 1), {0.1}), kCell);
  bool is_found = false;
  (void)for_each_pair(arm.wholes()[0], arm.wholes()[1], pose, [&](const auto& pair) {
    is_found = is_found || (pair.a == lit.a && pair.b == lit.b);
    return true;
  });
  CHECK(is_found);
}
