// The known-answer test of guards.
#include "flashbvh/robot/self_test.hpp"

#include "../self_test/known_answers.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"
#include "known_guard.hpp"
#include "known_robot.hpp"

namespace flashbvh {
namespace detail {
namespace {

/// More than a walk of the last period takes, if none is broken.
constexpr uint32_t kEnoughWork = 20'000;

}  // namespace

/// The hand turns and slides to the wall and into it, in slices of little work.
uint32_t known_guard_digest() {
  Mesh meshes[2];
  const Robot robot = view_robot_unchecked(kKnownRobot, meshes);
  GuardStateOf<2, 1, 2> state;
  Guard guard(robot, state);
  AnswerDigest digest;
  const auto add = [&](const GuardAnswer& answer) {
    digest.add(static_cast<uint32_t>(answer.status), static_cast<uint32_t>(answer.verdict));
    digest.add(answer.distance);
    digest.add(answer.work);
  };
  JointCoordinate values[2] = {kKnownTurn, 0};
  add(guard.prime(values));
  for (int i = 0; i < kKnownPeriods; ++i) {
    values[0] += kKnownTurnStep;
    values[1] += kKnownSlideStep;
    add(guard.update(values, kKnownWork));
  }
  add(guard.go_on(kEnoughWork));
  return digest.value();
}

}  // namespace detail

Status test_known_guard() {
  return detail::passed(detail::known_guard_digest(), 0x37D172ADu);
}

}  // namespace flashbvh
