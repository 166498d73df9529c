// How far a cell of values moves links, against values that were tried.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "robot/matrix/pair_space.hpp"
#include "robot/matrix/reaches.hpp"
#include "support/arms/arms.hpp"

using namespace flashbvh;
using namespace flashbvh::tool;
using namespace flashbvh::test;

namespace {

constexpr double kCell = 1e-4;

std::vector<double> any_point(Random& random, const PairSpace& space, double part) {
  std::vector<double> point;
  for (const Dimension& dimension : space.dimensions()) {
    const double middle = (dimension.range.lower + dimension.range.upper) / 2;
    const double half = (dimension.range.upper - dimension.range.lower) / 2 * part;
    point.push_back(real_between(random, middle - half, middle + half));
  }
  return point;
}

/// A pair of links of an arm, far enough from each other for several joints.
struct Pair {
  Model model;
  BakedArm arm;
  std::vector<double> reaches_a;
  std::vector<double> reaches_b;
  PairSpace space;

  explicit Pair(const Model& made)
      : model(made),
        arm(model, kCell),
        reaches_a(reaches_of(model, 0, kCell)),
        reaches_b(reaches_of(model, model.links.size() - 1, kCell)),
        space(model, {0, &arm.meshes().front(), &reaches_a},
              {model.links.size() - 1, &arm.meshes().back(), &reaches_b}, kCell) {}
};

}  // namespace

TEST_CASE("links come no nearer in a cell than its motion says") {
  CAPTURE(test_seed());
  Random random(test_seed());
  double tightest = 0;
  for (int round = 0; round < rounds(10, 30); ++round) {
    CAPTURE(round);
    const Pair pair(any_arm(random, 2 + random.below(4)));
    for (int i = 0; i < 10; ++i) {
      const std::vector<double> middle = any_point(random, pair.space, 0.8);
      std::vector<double> halves;
      for (const Dimension& dimension : pair.space.dimensions()) {
        halves.push_back(real_between(random, 0, 0.05) *
                         (dimension.range.upper - dimension.range.lower));
      }
      const double bound = pair.space.motion(middle, halves).sum + 2 * kPlacing;
      Witness<std::uint16_t> seed;
      const double before = pair.space.distance(middle, seed);
      for (int k = 0; k < 60; ++k) {
        std::vector<double> point = middle;
        for (std::size_t d = 0; d < point.size(); ++d) {
          // Corners of the cell, where most is moved.
          point[d] += random.below(2) == 0 ? halves[d] : -halves[d];
        }
        const double after = pair.space.distance(point, seed);
        REQUIRE(std::fabs(after - before) <= bound + 1);
        tightest = std::max(tightest, std::fabs(after - before) / bound);
      }
    }
  }
  CAPTURE(tightest);
  CHECK(tightest > 0.6);  // else this shows little
}

TEST_CASE("the motion of a cell: formulas") {
  // A large plate and a rod of length 1 on an upper arm of length 2, folded to a right angle.
  Model model;
  add_link(model, kNoJoint, box({-50, -50, -0.1}, {50, 50, 0}));
  const std::size_t shoulder =
      add_joint(model, kNoJoint, shifted({0, 0, 1}), JointType::revolute, -1, 1);
  const std::size_t elbow =
      add_joint(model, shoulder, shifted({2, 0, 0}), JointType::revolute, -kPi, kPi);
  add_link(model, elbow, box({0, 0, 0}, {1, 0.01, 0.01}));
  const double cell = 4e-3;
  const BakedArm arm(model, cell);
  const std::vector<double> reaches_a = reaches_of(model, 0, cell);
  const std::vector<double> reaches_b = reaches_of(model, 1, cell);
  const PairSpace space(model, {0, &arm.meshes()[0], &reaches_a}, {1, &arm.meshes()[1], &reaches_b},
                        cell);
  REQUIRE(space.dimensions()[0].variable == 0);
  const Motion motion = space.motion({0, kPi / 2}, {0.1, 0.2});
  CHECK(motion.parts[0] * cell == Approx(0.1 * std::sqrt(5.0)).epsilon(0.01));
  CHECK(motion.parts[1] * cell == Approx(0.2).epsilon(0.01));
  CHECK(motion.sum == Approx(motion.parts[0] + motion.parts[1]));
  // Stretched out it reaches further.
  CHECK(space.motion({0, 0}, {0.1, 0.2}).parts[0] * cell == Approx(0.3).epsilon(0.01));
}
