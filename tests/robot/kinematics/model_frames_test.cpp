// The frames of joints and links.
#include "robot/kinematics.hpp"
#include "support/arms/arms.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

double difference(const Transform& a, const Transform& b) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      most = std::max(most, std::fabs(a.rotation[i][j] - b.rotation[i][j]));
    }
    most = std::max(most, std::fabs(a.translation[i] - b.translation[i]));
  }
  return most;
}

}  // namespace

TEST_CASE("a joint turns about the z of its frame, or slides along it") {
  Model model;
  const std::size_t turning =
      add_joint(model, kNoJoint, composed(shifted({1, 2, 3}), turned(0, kPi / 2)),
                JointType::revolute, -2, 2);
  const std::size_t sliding =
      add_joint(model, turning, shifted({5, 0, 0}), JointType::prismatic, 0, 9);
  const std::size_t mimic = add_mimic(model, sliding, {}, JointType::revolute, 0, -2, 0.5);
  const std::vector<Transform> frames = frames_of(model, {kPi / 2, 4});
  // z points along the base's -y; a quarter turn takes x to the frame's y, which is the base's z.
  CHECK(difference(shifted(frames[turning].translation), shifted({1, 2, 3})) < 1e-12);
  CHECK(difference(shifted(frames[sliding].translation), shifted({1, 2 - 4, 3 + 5})) < 1e-12);
  CHECK(difference(frames[mimic], composed(frames[sliding], turned(2, 0.5 - kPi))) < 1e-12);
  CHECK(range_of_joint(model, mimic).lower == Approx(0.5 - 4).margin(1e-5));
  CHECK(range_of_joint(model, mimic).upper == Approx(0.5 + 4).margin(1e-5));
}
