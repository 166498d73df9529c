// Distance tables of random arms against brute force: no place in a cell falls below what it says.
#include "robot/baked/fixed_robot.hpp"

#include <catch2/catch.hpp>

#include "flashbvh/detail/robot/distance_table.hpp"
#include "flashbvh/robot/distance_table.hpp"
#include "support/arms/guarded_arm.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

struct Told {
  std::uint32_t places;  ///< with a bound
  std::uint32_t all;
};

/// Of random values: exact queries find the links no nearer than their distance table says.
Told told_of(const FixedArm& arm, Random& random) {
  Told told{};
  std::vector<JointCoordinate> coordinates(arm.robot().joint_count);
  for (int i = 0; i < 2000; ++i) {
    const Values values = arm.any_values(random);
    REQUIRE(set_coordinates(arm.robot(), values.data(), coordinates.data()) == Status::done);
    for (std::uint16_t pair = 0; pair < arm.robot().pair_count; ++pair) {
      const RobotPair& of = arm.robot().pairs[pair];
      const std::uint32_t distance =
          detail::table_distance_at(arm.robot(), pair, coordinates.data());
      if (distance > kPlacingFine && arm.is_closer(of, values, distance - kPlacingFine)) {
        CAPTURE(i, pair, distance);
        FAIL();
      }
      told.places += distance != 0 ? 1 : 0;
      told.all += distance_table_size(arm.robot(), of) != 0 ? 1 : 0;
    }
  }
  return told;
}

}  // namespace

TEST_CASE("nowhere are two links nearer than their distance table says") {
  CAPTURE(test_seed());
  Random random(test_seed());
  std::uint32_t all = 0;
  for (int round = 0; round < 8; ++round) {
    CAPTURE(round);
    all += told_of(any_guarded_arm(random, 3, 1e-3), random).all;
  }
  CHECK(all > 0);
}

TEST_CASE(
    "what lies in the sweep of a link, or next to it, is as near as it is, and a distance table "
    "says so") {
  CAPTURE(test_seed());
  Random random(test_seed());
  const bake::SourceMesh pin = box({-0.01, 0.03, 0.1}, {0.01, 0.05, 0.15});
  const bake::SourceMesh wall = box({0.25, -0.1, 0}, {0.3, 0.1, 0.2});
  for (const double cell : {1e-3, 0.3 / 32765}) {  // the second fits the blade, not its sweep
    CAPTURE(cell);
    for (const bake::SourceMesh& mesh : {pin, wall}) {
      const FixedArm arm(blade_and(mesh, -0.12, 0.12), cell, {{0, 1, 0.01, 0.01}}, true);
      const Told told = told_of(arm, random);
      CHECK((told.places > told.all / 10 && told.all == 2000));
    }
  }
}

TEST_CASE("a byte's distance grows with it by a sixteenth at most") {
  CHECK(table_distance(0) == 0);
  for (std::uint32_t byte = 1; byte < 255; ++byte) {
    const double now = table_distance(static_cast<std::uint8_t>(byte));
    const double next = table_distance(static_cast<std::uint8_t>(byte + 1));
    CHECK((next > now && next <= now * 17 / 16));
  }
}
