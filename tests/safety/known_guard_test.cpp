// The known guard's verdicts are right, by brute force on all triangle pairs at each period's end.
#include "robot/known_guard.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"
#include "robot/known_robot.hpp"
#include "support/all_distances.hpp"
#include "support/arms/placed_links.hpp"
#include "support/test.hpp"

namespace {

/// The distance of the hand from the wall, in 1/256 cell, rounded down.
std::uint32_t true_distance(const Robot& robot, const Values& values) {
  const Values coordinates = coordinates_of(robot, values);
  REQUIRE_FALSE(coordinates.empty());
  const Pose pose = PlacedLinks(robot, coordinates).pose(0, 1);
  return lower_of(least_of(all_distances(robot.meshes[0], robot.meshes[1], pose)).squared);
}

}  // namespace

TEST_CASE("the known guard is free, warns and stops where brute force says so") {
  Mesh meshes[2];
  Robot robot{};
  REQUIRE(open_robot(detail::kKnownRobot, sizeof detail::kKnownRobot, meshes, 2, robot) ==
          Status::done);
  const RobotPair& pair = robot.pairs[0];
  GuardStateOf<2, 1, 2> state;
  Guard guard(robot, state);
  Values values = {detail::kKnownStart[0], detail::kKnownStart[1]};
  std::uint32_t verdicts = 0;
  for (int i = 0; i < detail::kKnownPeriods; ++i) {
    const GuardAnswer answer = guard.update(values.data(), detail::kKnownWork);
    const std::uint32_t truth = true_distance(robot, values) + 1;
    CAPTURE(i, truth, answer.distance);
    REQUIRE(answer.status == Status::done);
    CHECK(answer.distance <= truth);
    CHECK((answer.verdict != Verdict::free || truth > pair.warn));
    CHECK((answer.verdict > Verdict::warn || truth > pair.stop));
    verdicts |= 1u << static_cast<std::uint32_t>(answer.verdict);
    values[0] += detail::kKnownStep[0];
    values[1] += detail::kKnownStep[1];
  }
  CHECK(verdicts == 0xF);  // free, warn, not yet known, stop
}
