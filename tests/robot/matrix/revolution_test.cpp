// Solids of revolution, and proofs that use them.
#include "flashbvh/solid.hpp"
#include "robot/matrix/pair_search.hpp"
#include "robot/matrix/swept_pair.hpp"
#include "support/arms/arms.hpp"
#include "support/surface.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

bool is_proven(const Model& model, double cell) {
  std::uint64_t joint_boxes = 0;
  const bool proven = is_proven_swept(model, 0, 1, cell, {}, joint_boxes);
  CHECK(joint_boxes <= MatrixOptions().most_joint_boxes);
  return proven;
}

}  // namespace

TEST_CASE("a solid of revolution holds its mesh at every angle") {
  for_rounds(rounds(4, 10), [&](Random& random, int round) {
    const double cell = 1e-3;
    Model model = any_arm(random, 1);
    const Transform axis = model.joints[0].fixed;
    const bake::SourceMesh mesh = model.links[0].mesh;
    model.links[0].mesh = revolved(mesh, axis, 1.8 * cell, round % 2 == 0 ? kCoarse : kFine);
    const BakedArm arm(model, cell);
    const WholeMesh& solid = arm.wholes()[0];
    REQUIRE(solid.is_closed);
    REQUIRE(solid.shell_count == 1);
    for (int i = 0; i < 200; ++i) {
      const Transform spun =
          composed(axis, composed(turned(2, real_between(random, -kPi, kPi)), inverse(axis)));
      const Vector3 p = placed(spun, any_point_of(random, mesh));
      const auto cells = [&](std::size_t k) {
        return static_cast<std::int32_t>(std::round(p[k] / cell));
      };
      REQUIRE(inside(solid, {cells(0), cells(1), cells(2)}).side == PointSide::inside);
    }
  });
}

TEST_CASE("what a turning link sweeps proves, but not by what lies inside it") {
  for (const double cell : {1e-3, 1e-5}) {  // in the second, the solids exceed the lattice
    CAPTURE(cell);
    // A wall that the blade's sweep, 0.1005 wide plus the solid's sides, meets or misses.
    const bake::SourceMesh wall = box({0.25, -0.2, -0.1}, {0.3, 0.2, 0.2});
    CHECK(is_proven(blade_and(wall, 0, 0.13), cell));
    CHECK_FALSE(is_proven(blade_and(wall, 0, 0.16), cell));
    // A pin wholly inside the sweep; no surface of the solid meets it.
    const bake::SourceMesh pin = box({-0.01, 0.03, 0.1}, {0.01, 0.05, 0.15});
    CHECK_FALSE(is_proven(blade_and(pin, -0.02, 0.02), cell));
  }
}

TEST_CASE("a link that turns by several turns next to a wall is proven quickly") {
  // Twelve corners, whose circle passes a plate at a hundred cells.
  Model model;
  const double cell = 1e-4;
  add_link(model, kNoJoint, box({0.1 + 100 * cell, -1, -1}, {0.11, 1, 1}));
  const std::size_t first =
      add_joint(model, kNoJoint, turned(0, kPi / 2), JointType::prismatic, -0.4, 0.4);
  const std::size_t second =
      add_joint(model, first, turned(0, -kPi / 2), JointType::prismatic, -0.4, 0.4);
  const std::size_t spindle = add_joint(model, second, {}, JointType::revolute, -6.3, 6.3);
  add_link(model, spindle, prism(12, 0.1, 0, 0, -0.3, 0.3));
  MatrixOptions options;
  options.most_joint_boxes = 400'000;
  const BakedArm arm(model, cell);
  const PairVerdict pair = arm.decide(options)[0];
  CHECK(pair.verdict == MatrixVerdict::never);
  CHECK(pair.reason.find("by solids of revolution") != std::string::npos);
  CHECK(pair.joint_boxes < 50'000);
}
