/* The guide's robot examples in C, with the arm of firmware_examples/robot_guard. */
#include "guide_10.c"

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
