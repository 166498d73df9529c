// Known-answer test of guards.
#include "flashbvh/robot/self_test.hpp"

#include "../self_test/answer_digest.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"
#include "known_guard.hpp"
#include "known_robot.hpp"

namespace flashbvh {
namespace detail {
namespace {

/// More work than a period's walk takes on a core without faults.
constexpr uint32_t kEnoughWork = 20'000;

void add(const GuardAnswer& answer, AnswerDigest& digest) {
  digest.add(static_cast<uint32_t>(answer.status), static_cast<uint32_t>(answer.verdict));
  digest.add(answer.distance);
  digest.add(answer.work);
}

/// Turns and slides the hand to the wall and past it, with little work per period.
[[gnu::noinline]] void move_hand(const Robot& robot, AnswerDigest& digest) {
  GuardStateOf<2, 1, 2> state;
  Guard guard(robot, state);
  JointCoordinate values[2] = {kKnownStart[0], kKnownStart[1]};
  add(guard.update(values, kEnoughWork), digest);
  for (int i = 0; i < kKnownPeriods; ++i) {
    values[0] += kKnownStep[0];
    values[1] += kKnownStep[1];
    add(guard.update(values, kKnownWork), digest);
  }
  add(guard.go_on(kEnoughWork), digest);
}

}  // namespace

/// Runs the motion with the robot's distance table and without it.
uint32_t known_guard_digest() {
  Mesh meshes[2];
  Robot robot = view_robot_unchecked(kKnownRobot, meshes);
  AnswerDigest digest;
  move_hand(robot, digest);
  robot.distance_table_bytes = 0;
  move_hand(robot, digest);
  return digest.value();
}

}  // namespace detail

Status test_known_guard() {
  return detail::passed(detail::known_guard_digest(), 0x9F9C81F0u);
}

}  // namespace flashbvh
