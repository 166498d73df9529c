// What the guard says of a pair: where it is near, and how each joint changes that.
#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

#include "support/arms/any_workcell.hpp"

using namespace flashbvh;
using namespace flashbvh::tool;
using namespace flashbvh::test;

namespace {

/// How far a unit of the variable moves the pair at most, in 1/256 cell.
double reach_of(const Robot& robot, const RobotPair& pair, std::size_t variable) {
  double sum = 0;
  const auto add = [&](std::uint8_t link, std::uint8_t count) {
    std::uint8_t joint = robot.links[link].joint;
    for (std::uint32_t i = 0; i < count; ++i) {
      const RobotJoint& of = robot.joints[joint];
      const double factor = std::ldexp(std::abs(of.multiplier), -of.shift);
      const double reach =
          std::ldexp(robot.reaches[robot.links[link].first_reach + i], -kReachBits);
      sum += of.variable == variable ? reach * factor : 0;
      joint = of.parent;
    }
  };
  add(pair.a, pair.joints_a);
  add(pair.b, pair.joints_b);
  return sum;
}

}  // namespace

TEST_CASE("what is explained of a pair is where it is near, and how its joints move that") {
  CAPTURE(test_seed());
  Random random(test_seed());
  int told = 0;
  const int tries = rounds(4, 12);
  for (int round = 0; round < tries; ++round) {
    CAPTURE(round);
    const auto cell = std::make_unique<CrowdedCell>(random);
    const Robot& robot = cell->robot();
    const auto state = std::make_unique<WorkcellState>();
    Guard guard(robot, *state);
    const Values before = cell->arm.any_values(random);
    std::int32_t changes[8] = {};
    REQUIRE(guard.explain(0, changes).status == Status::guard_state_invalid);
    (void)guard.prime(before.data());
    REQUIRE(guard.explain(robot.pair_count, changes).status == Status::guard_state_invalid);
    for (std::uint16_t i = 0; i < robot.pair_count; ++i) {
      const PairDetail detail = guard.explain(i, changes);
      const RobotPair& pair = robot.pairs[i];
      REQUIRE(detail.status == Status::done);
      if (detail.nearest.lower < 1000) {
        continue;  // its direction is rounded by a part of it
      }
      ++told;
      const auto point = [](const FinePoint& p) {
        return Vector3{static_cast<double>(p.x) / 256 * kWorkcellCell,
                       static_cast<double>(p.y) / 256 * kWorkcellCell,
                       static_cast<double>(p.z) / 256 * kWorkcellCell};
      };
      const auto seen_from = [&](std::uint8_t link, const FinePoint& p) {
        return placed(inverse(cell->frame_of(link, before, 1)), point(p));
      };
      const Vector3 in_a = seen_from(pair.a, detail.nearest.point_a);
      const Vector3 in_b = seen_from(pair.b, detail.nearest.point_b);
      const auto distance_at = [&](const Values& values) {
        const Vector3 p = placed(cell->frame_of(pair.a, values, 1), in_a);
        const Vector3 q = placed(cell->frame_of(pair.b, values, 1), in_b);
        return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) / kWorkcellCell * 256;
      };
      CHECK(std::abs(distance_at(before) - detail.nearest.lower) < 4);
      double most = 0;
      for (std::size_t v = 0; v < before.size(); ++v) {
        constexpr JointCoordinate by = 1 << 6;
        Values up = before;
        Values down = before;
        up[v] += by;
        down[v] -= by;
        const double change = (distance_at(up) - distance_at(down)) / (2 * by);
        const double wrong = std::abs(std::ldexp(changes[v], -kReachBits) - change);
        // Points are rounded to 1/256 cell, changes to 2^-kReachBits.
        CHECK(wrong <= 4 * reach_of(robot, pair, v) / detail.nearest.lower +
                           1e-4 * std::abs(change) + 0x1p-24);
        most = std::max(most, std::abs(static_cast<double>(changes[v])));
      }
      CHECK((detail.variable == kNoVariable ? most == 0
                                            : std::abs(changes[detail.variable]) == most));
    }
  }
  CHECK(told > 8 * tries);
}
