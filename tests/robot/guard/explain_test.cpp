// The guard's explanation of a pair: the nearest points, and each joint's influence.
#include "support/arms/any_workcell.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

/// An upper bound of the pair's motion per unit of the variable, in 1/256 cell.
double reach_of(const Robot& robot, const RobotPair& pair, std::size_t variable) {
  double sum = 0;
  for_each_reach(robot, pair, [&](std::uint32_t joint, double reach) {
    const RobotJoint& of = robot.joints[joint];
    sum += of.variable == variable ? reach * std::ldexp(std::abs(of.multiplier), -of.shift) : 0;
  });
  return sum;
}

}  // namespace

TEST_CASE("what is explained of a pair is where it is near, and how its joints move that") {
  int explained = 0;
  const int tries = rounds(4, 12);
  for_rounds(tries, [&](Random& random, int) {
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
        continue;  // rounding changes its direction too much
      }
      ++explained;
      constexpr double kFine = kWorkcellCell / 256;
      const auto seen_from = [&](std::uint8_t link, const FinePoint& p) {
        const Vector3 point = {double(p.x) * kFine, double(p.y) * kFine, double(p.z) * kFine};
        return placed(inverse(cell->frame_of(link, before, 1)), point);
      };
      const Vector3 in_a = seen_from(pair.a, detail.nearest.point_a);
      const Vector3 in_b = seen_from(pair.b, detail.nearest.point_b);
      const auto distance_at = [&](const Values& values) {
        const Vector3 p = placed(cell->frame_of(pair.a, values, 1), in_a);
        const Vector3 q = placed(cell->frame_of(pair.b, values, 1), in_b);
        return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) / kFine;
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
  });
  CHECK(explained > 8 * tries);
}

TEST_CASE("of a period the variable is named that brought two links nearer by most") {
  long named[3] = {};
  long none = 0;
  for_rounds(20, [&](Random& random, std::size_t round) {
    // A carriage that slides, an arm on it, and a forearm that mimics the arm.
    Model model;
    const std::size_t carriage =
        add_joint(model, tool::kNoJoint, turned(1, kPi / 2), JointType::prismatic, -1, 1);
    const std::size_t arm_joint =
        add_joint(model, carriage, turned(1, -kPi / 2), JointType::revolute, -3, 3);
    const std::size_t mimic =
        add_mimic(model, arm_joint, shifted({0.5, 0, 0}), JointType::revolute, 1, -0.5, 0);
    add_joint(model, mimic, shifted({0.5, 0, 0}), JointType::revolute, -3, 3);
    add_link(model, 3, box({0, -0.02, -0.02}, {0.3, 0.02, 0.02}));
    add_link(model, tool::kNoJoint, box({1.7, -1, -0.1}, {1.8, 1, 0.1}));
    const FixedArm arm(model, 1e-3, {{0, 1, 0.01, 0.02}});
    const auto state = std::make_unique<AnyGuardState>();
    Guard guard(arm.robot(), *state);
    const auto near = [&](double centre, std::size_t v) {
      return static_cast<JointCoordinate>((centre + real_between(random, -0.3, 0.3)) /
                                          arm.unit_of(v));
    };
    const Values from = {near(0, 0), near(0, 1), near(0, 2)};
    std::int32_t changes[3];
    (void)guard.prime(from.data());
    REQUIRE(guard.explain(0, changes).status == Status::done);
    Values to = from;
    const std::size_t nearer = round % 5;  // this one alone comes nearer; 3: none; 4: any
    for (std::size_t v = 0; v < 3; ++v) {
      const auto any =
          static_cast<JointCoordinate>(real_between(random, -1e-3, 1e-3) / arm.unit_of(v));
      const JointCoordinate away = changes[v] < 0 ? -std::abs(any) : std::abs(any);
      to[v] += nearer == 4 ? any : nearer == v ? -away : away;
    }
    REQUIRE(guard.update(to.data(), UINT32_MAX).status == Status::done);
    const PairDetail detail = guard.explain(0, changes);
    REQUIRE(detail.status == Status::done);
    const auto way_of = [&](std::size_t v) { return 1.0 * changes[v] * (to[v] - from[v]); };
    double nearest = 0;
    for (std::size_t v = 0; v < 3; ++v) {
      nearest = std::min(nearest, way_of(v));
    }
    if (nearest == 0) {
      ++none;
      return;
    }
    REQUIRE(detail.variable < 3);
    CHECK(way_of(detail.variable) <= 0.99 * nearest);
    ++named[detail.variable];
  });
  CHECK(named[0] > 0);
  CHECK(named[1] > 0);
  CHECK(named[2] > 0);
  CHECK(none > 0);
}
