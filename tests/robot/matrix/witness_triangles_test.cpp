// The triangles of a pair's witness.
#include "robot/matrix/witness_triangles.hpp"
#include "flashbvh/collide.hpp"
#include "support/arms/arms.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

constexpr double kCell = 1e-4;

/// A block that slides from -1 to 1 past a pin at 0; together they are 2 * `reach` wide.
Model sliding(double reach) {
  Model model;
  add_link(model, kNoJoint, box({-reach / 2, 0, 0}, {reach / 2, 0.1, 0.1}));
  const std::size_t joint =
      add_joint(model, kNoJoint, turned(1, kPi / 2), JointType::prismatic, -1, 1);
  add_link(model, joint, box({-0.05, 0.05, -reach / 2}, {0.15, 0.2, reach / 2}));
  return model;
}

}  // namespace

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
