/* The guide's robot examples in C, with the arm of firmware_examples/robot_guard. */
#include <flashbvh/robot.h>

#include "c_arm.robot.h"

static uint32_t arm_state[c_arm_GUARD_STATE_SIZE / 4];
static flashbvh_mesh arm_links[c_arm_LINK_COUNT];
static flashbvh_robot arm_robot;
static flashbvh_guard arm;

static bool may_go(flashbvh_guard_answer answer) {
  return answer.status == FLASHBVH_STATUS_DONE && answer.verdict <= FLASHBVH_VERDICT_WARN;
}

/** Before the first period, at rest. */
static bool arm_start(const float joints[c_arm_VARIABLE_COUNT]) {
  flashbvh_joint_coordinate values[c_arm_VARIABLE_COUNT];
  flashbvh_view_robot_unchecked(c_arm_robot_image, arm_links, &arm_robot);
  flashbvh_set_values(&arm_robot, joints, values);
  return flashbvh_guard_init(&arm, &arm_robot, arm_state, sizeof arm_state) ==
             FLASHBVH_STATUS_DONE &&
         may_go(flashbvh_guard_prime(&arm, values));
}

/** Each period's set point goes to the drives only if it may. */
static bool arm_tick(const float joints[c_arm_VARIABLE_COUNT]) {
  flashbvh_joint_coordinate values[c_arm_VARIABLE_COUNT];
  flashbvh_set_values(&arm_robot, joints, values);
  return may_go(flashbvh_guard_update(&arm, values, 150));
}

/** The elbow folds until the gripper would hit the arm. */
int main(void) {
  float joints[c_arm_VARIABLE_COUNT] = {0, 0, 0.5f, 1.5f};
  if (!arm_start(joints)) {
    return 1;
  }
  while (joints[c_arm_variable_elbow] < 2.9f && arm_tick(joints)) {
    joints[c_arm_variable_elbow] += 0.002f;
  }
  return joints[c_arm_variable_elbow] > 2 && joints[c_arm_variable_elbow] < 2.9f ? 0 : 2;
}
