// Charts of random arms against brute force: no place in a cell falls below what it says.
#include "robot/charts.hpp"

#include <catch2/catch.hpp>

#include "flashbvh/detail/robot_chart.hpp"
#include "robot/guarded_arm.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

TEST_CASE("nowhere are two links nearer than their chart says, and charts say something") {
  CAPTURE(test_seed());
  Random random(test_seed());
  std::uint32_t told = 0;
  std::uint32_t all = 0;
  for (int round = 0; round < 8; ++round) {
    const FixedArm arm = any_guarded_arm(random, 3, 1e-3);
    std::vector<JointCoordinate> coordinates(arm.robot().joint_count);
    for (int i = 0; i < 2000; ++i) {
      const Values values = arm.any_values(random);
      REQUIRE(set_coordinates(arm.robot(), values.data(), coordinates.data()) == Status::done);
      for (std::uint16_t pair = 0; pair < arm.robot().pair_count; ++pair) {
        const RobotPair& of = arm.robot().pairs[pair];
        const std::uint32_t distance =
            detail::chart_distance_at(arm.robot(), pair, coordinates.data());
        CAPTURE(round, i, pair, distance);
        REQUIRE((distance <= kPlacingFine || !arm.is_closer(of, values, distance - kPlacingFine)));
        told += distance != 0 ? 1 : 0;
        all += detail::chart_size(arm.robot(), of) != 0 ? 1 : 0;
      }
    }
  }
  CHECK(told > all / 10);
}

TEST_CASE("a byte's distance grows with it by a sixteenth at most") {
  CHECK(detail::chart_distance(0) == 0);
  for (std::uint32_t byte = 1; byte < 255; ++byte) {
    const double now = detail::chart_distance(static_cast<std::uint8_t>(byte));
    const double next = detail::chart_distance(static_cast<std::uint8_t>(byte + 1));
    CHECK((next > now && next <= now * 17 / 16));
  }
}
