// `warn` is said of pairs that are that near, or for which the work budget was too small.
#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>

#include "flashbvh/robot/workcell.hpp"
#include "support/arms/guarded_arm.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

constexpr double kCell = 1e-5;
/// The cart goes less far than its driver says, by so much.
constexpr double kBeyond = 1.3;

std::uint32_t fine(double length) {
  return static_cast<std::uint32_t>(length / kCell * 256);
}

}  // namespace

TEST_CASE("a cart that comes nearer is warned of where it is near, not where its sphere is") {
  Model model;
  add_joint(model, tool::kNoJoint, Transform(), JointType::revolute, -1, 1);
  add_link(model, tool::kNoJoint, box({-0.03, -0.03, -0.5}, {0.03, 0.03, -0.44}));
  add_link(model, 0, box({-0.03, -0.03, -0.03}, {0.03, 0.03, 0.03}));
  const FixedArm arm(model, kCell);
  Model of_cart;
  add_link(of_cart, tool::kNoJoint, box({-0.03, -0.03, -0.03}, {0.03, 0.03, 0.03}));
  const BakedArm cart(of_cart, kCell);
  for (const double step : {0.0005, 0.0002, 0.002, 0.00003}) {
    CAPTURE(step);
    WorkcellOf<3, 3, 2, 4> memory;
    Workcell workcell(arm.robot(), memory);
    Frame at = kIdentityFrame;
    at.translation[0] = static_cast<std::int32_t>(0.4 / kCell * kFrameCell);
    std::uint8_t link = 0;
    REQUIRE(workcell.add(cart.meshes()[0], {kBase, at}, link) == Status::done);
    REQUIRE(workcell.keep_apart(1, link, fine(0.001), fine(0.01)) == Status::done);
    GuardStateOf<3, 2, 4> state;
    Guard guard(workcell.robot(), state);
    const JointCoordinate value = 0;
    REQUIRE(guard.prime(&value).verdict == Verdict::free);
    const auto way = static_cast<std::int32_t>(step / kCell * kFrameCell);
    const std::uint32_t moved = fine(kBeyond * step);
    double apart = 0.4 - 0.06;
    long verdicts[5] = {};
    while (apart > 0.002) {
      at.translation[0] -= way;
      apart = at.translation[0] * kCell / kFrameCell - 0.06;
      REQUIRE(workcell.move(link, at, moved) == Status::done);
      const GuardAnswer answer = guard.update(&value, 300);
      CAPTURE(apart, answer.distance * kCell / 256);
      REQUIRE(answer.verdict <= Verdict::stop);
      REQUIRE((answer.verdict == Verdict::free ||
               apart < 0.01 + kBeyond * step + (2 * workcell.robot().slack + 8) * kCell / 256));
      ++verdicts[static_cast<int>(answer.verdict)];
    }
    CHECK(verdicts[static_cast<int>(Verdict::free)] > 0);
    CHECK(verdicts[static_cast<int>(Verdict::warn)] > 0);
  }
}
