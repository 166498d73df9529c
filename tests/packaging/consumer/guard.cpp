// Ends with 0 if the arm may turn away and must stop where it meets its base.
#include <flashbvh/robot/robot_float.hpp>

#include "arm.robot.hpp"

namespace {

arm::GuardState state;

flashbvh::Verdict verdict_at(float radians) {
  flashbvh::Guard guard(arm::robot, state);
  flashbvh::JointCoordinate value;
  flashbvh::set_values(arm::robot, &radians, &value);
  return guard.prime(&value).verdict;
}

}  // namespace

int main() {
  static_assert(arm::kPairCount == 1 && arm::kVariableCount == 1, "");
  return verdict_at(-1.25f) == flashbvh::Verdict::free &&
                 verdict_at(1.25f) == flashbvh::Verdict::stop
             ? 0
             : 1;
}
