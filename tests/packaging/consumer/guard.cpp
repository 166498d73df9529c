// Exits with 0 if the arm may turn away and must stop where it meets its base.
#include <flashbvh/robot/guard.hpp>
#include <flashbvh/robot/image.hpp>
#include <flashbvh/robot/robot_float.hpp>

#include "arm.robot.h"

namespace {

flashbvh::Mesh meshes[arm_LINK_COUNT];
const flashbvh::Robot robot = flashbvh::view_robot_unchecked(arm_robot_image, meshes);
flashbvh::GuardStateOf<arm_JOINT_COUNT, arm_PAIR_COUNT, arm_PAIR_JOINT_COUNT> state;

flashbvh::Verdict verdict_at(float radians) {
  flashbvh::Guard guard(robot, state);
  flashbvh::JointCoordinate value;
  flashbvh::set_values(robot, &radians, &value);
  return guard.prime(&value).verdict;
}

}  // namespace

int main() {
  static_assert(arm_PAIR_COUNT == 1 && arm_VARIABLE_COUNT == 1, "");
  return verdict_at(-1.25f) == flashbvh::Verdict::free &&
                 verdict_at(1.25f) == flashbvh::Verdict::stop
             ? 0
             : 1;
}
