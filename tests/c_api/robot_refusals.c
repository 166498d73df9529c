/* What robot.h refuses, each with the status that C++ gives. */
#include "robot.h"

#include <string.h>

#include "c_arm.robot.h"

enum { HALF_TURN = FLASHBVH_FULL_TURN / 2 };

static long failures;

static void check(bool holds) {
  failures += holds ? 0 : 1;
}

static void check_memory(void) {
  uint64_t* const memory = scratch;
  uint32_t* const state = (uint32_t*)scratch;
  const size_t size = FLASHBVH_WORKCELL_SIZE(4, 6, 6, 10);
  const flashbvh_workcell_room room = {4, 6, 6, 10};
  const flashbvh_workcell_room rooms[] = {
      {3, 6, 6, 10}, {4, 5, 6, 10}, {4, 6, 5, 10}, {4, 6, 6, 9}, {4, 6, 6, UINT32_MAX}};
  const flashbvh_joint_coordinate values[VARIABLES] = {0, 0, 0, 0};
  const flashbvh_mount mount = {0, {{{0}}, {0}}};
  int32_t changes[VARIABLES];
  uint8_t link = 77;
  flashbvh_guard guard;
  flashbvh_motion motion;
  flashbvh_workcell cell;
  flashbvh_pair_detail detail;
  memset(scratch, 0, sizeof scratch);
  check(flashbvh_guard_init(&guard, &c_arm_robot, state, c_arm_GUARD_STATE_SIZE - 1) ==
        FLASHBVH_STATUS_GUARD_STATE_INVALID);
  check(flashbvh_guard_prime(&guard, values).status == FLASHBVH_STATUS_GUARD_STATE_INVALID);
  check(flashbvh_guard_update(&guard, values, 1).verdict == FLASHBVH_VERDICT_REFUSED);
  check(flashbvh_guard_resume(&guard) == FLASHBVH_STATUS_GUARD_STATE_INVALID);
  check(flashbvh_guard_explain(&guard, 0, changes, &detail) == FLASHBVH_STATUS_GUARD_STATE_INVALID);
  check(detail.variable == FLASHBVH_NO_VARIABLE);
  check(flashbvh_guard_init(&guard, &c_arm_robot, (char*)state + 2, c_arm_GUARD_STATE_SIZE) ==
        FLASHBVH_STATUS_GUARD_STATE_INVALID);
  check(flashbvh_motion_init(&motion, &c_arm_robot, state, c_arm_MOTION_STATE_SIZE - 1) ==
        FLASHBVH_STATUS_GUARD_STATE_INVALID);
  check(flashbvh_motion_start(&motion, values, values) == FLASHBVH_STATUS_GUARD_STATE_INVALID);
  check(flashbvh_motion_run(&motion, 1).status == FLASHBVH_STATUS_GUARD_STATE_INVALID);
  check(flashbvh_motion_init(&motion, &c_arm_robot, (char*)state + 1, c_arm_MOTION_STATE_SIZE) ==
        FLASHBVH_STATUS_GUARD_STATE_INVALID);
  for (size_t i = 0; i < SCRATCH_WORDS; ++i) {
    check(memory[i] == 0); /* what is refused is not written */
  }
  check(c_arm_REACH_COUNT == 10);
  check(flashbvh_workcell_init(&cell, &c_arm_robot, memory, size, &room) == FLASHBVH_STATUS_DONE);
  check(flashbvh_workcell_init(&cell, &c_arm_robot, memory, size - 8, &room) ==
        FLASHBVH_STATUS_WORKCELL_FULL);
  check(flashbvh_workcell_init(&cell, &c_arm_robot, (char*)memory + 4, size, &room) ==
        FLASHBVH_STATUS_WORKCELL_FULL);
  for (size_t i = 0; i < sizeof rooms / sizeof rooms[0]; ++i) {
    check(flashbvh_workcell_init(&cell, &c_arm_robot, memory, size, &rooms[i]) ==
          FLASHBVH_STATUS_WORKCELL_FULL);
    check(flashbvh_workcell_add(&cell, &c_arm_robot.meshes[0], &mount, &link) ==
          FLASHBVH_STATUS_WORKCELL_FULL);
    check(link == 77);
  }
}

static void check_values(void) {
  const float floats[VARIABLES] = {0, 0, 1e30f, 0};
  flashbvh_joint_coordinate values[VARIABLES] = {0, 0, 0, 0};
  flashbvh_joint_coordinate coordinates[c_arm_JOINT_COUNT];
  int32_t changes[VARIABLES];
  flashbvh_guard guard;
  flashbvh_motion motion;
  flashbvh_pair_detail detail;
  check(flashbvh_guard_init(&guard, &c_arm_robot, scratch, sizeof scratch) == FLASHBVH_STATUS_DONE);
  check(flashbvh_guard_explain(&guard, 0, changes, &detail) == FLASHBVH_STATUS_GUARD_STATE_INVALID);
  check(flashbvh_guard_prime(&guard, values).status == FLASHBVH_STATUS_DONE);
  check(flashbvh_guard_explain(&guard, c_arm_PAIR_COUNT, changes, &detail) ==
        FLASHBVH_STATUS_GUARD_STATE_INVALID);
  values[c_arm_variable_roll] = HALF_TURN;
  check(flashbvh_guard_update(&guard, values, 1).status == FLASHBVH_STATUS_JOINT_JUMPED);
  values[c_arm_variable_roll] = 0;
  values[c_arm_variable_turn] = HALF_TURN;
  check(flashbvh_guard_update(&guard, values, 1).status == FLASHBVH_STATUS_JOINT_OUT_OF_LIMITS);
  flashbvh_set_values(&c_arm_robot, floats, values);
  check(values[c_arm_variable_elbow] == FLASHBVH_NO_COORDINATE);
  check(flashbvh_guard_update(&guard, values, 1).status == FLASHBVH_STATUS_NOT_A_COORDINATE);
  check(flashbvh_set_coordinates(&c_arm_robot, values, coordinates) ==
        FLASHBVH_STATUS_NOT_A_COORDINATE);
  check(flashbvh_guard_go_on(&guard, UINT32_MAX).status == FLASHBVH_STATUS_DONE);
  check(flashbvh_motion_init(&motion, &c_arm_robot, scratch, sizeof scratch) ==
        FLASHBVH_STATUS_DONE);
  check(flashbvh_motion_start(&motion, values, values) == FLASHBVH_STATUS_NOT_A_COORDINATE);
  check(flashbvh_motion_run(&motion, 1).status == FLASHBVH_STATUS_NOT_A_COORDINATE);
  check(flashbvh_slide_coordinate(1e30f, 1) == FLASHBVH_NO_COORDINATE);
}

static void check_bodies(void) {
  const flashbvh_workcell_room room = {5, 7, 7, 11};
  const flashbvh_mesh* const mesh = &c_arm_robot.meshes[c_arm_link_turret];
  const float upright[4] = {1, 0, 0, 0};
  const float far[3] = {1e6f, 0, 0};
  flashbvh_mount at = c_arm_mount_base;
  flashbvh_mount skew = c_arm_mount_base;
  flashbvh_mount off = c_arm_mount_base;
  flashbvh_frame frame;
  flashbvh_workcell cell;
  uint8_t link = 0;
  skew.frame.rotation[0][0] /= 2;
  off.frame.translation[0] = (int32_t)1 << 30;
  check(flashbvh_set_frame_of_quaternion(&c_arm_robot, upright, far, &frame) ==
        FLASHBVH_STATUS_TRANSLATION_OUT_OF_RANGE);
  check(flashbvh_workcell_init(&cell, &c_arm_robot, scratch, sizeof scratch, &room) ==
        FLASHBVH_STATUS_DONE);
  at.joint = c_arm_JOINT_COUNT;
  check(flashbvh_workcell_add(&cell, mesh, &at, &link) == FLASHBVH_STATUS_LINK_INVALID);
  check(flashbvh_workcell_add(&cell, mesh, &skew, &link) == FLASHBVH_STATUS_NOT_A_ROTATION);
  check(flashbvh_workcell_add(&cell, mesh, &off, &link) ==
        FLASHBVH_STATUS_TRANSLATION_OUT_OF_RANGE);
  check(link == 0);
  check(flashbvh_workcell_add(&cell, mesh, &c_arm_mount_base, &link) == FLASHBVH_STATUS_DONE);
  check(link == c_arm_LINK_COUNT);
  check(flashbvh_workcell_add(&cell, mesh, &c_arm_mount_base, &link) ==
        FLASHBVH_STATUS_WORKCELL_FULL);
  check(flashbvh_workcell_keep_apart(&cell, 0, 99, 0, 0) == FLASHBVH_STATUS_LINK_INVALID);
  check(flashbvh_workcell_keep_apart(&cell, 2, link, 2, 1) ==
        FLASHBVH_STATUS_DISTANCE_OUT_OF_RANGE);
  check(flashbvh_workcell_keep_apart(&cell, 2, link, 1, 2) == FLASHBVH_STATUS_DONE);
  check(flashbvh_workcell_keep_apart(&cell, 3, link, 1, 2) == FLASHBVH_STATUS_WORKCELL_FULL);
  check(flashbvh_workcell_robot(&cell)->pair_count == c_arm_PAIR_COUNT + 1);
  check(flashbvh_workcell_move(&cell, 2, &at.frame, 0) == FLASHBVH_STATUS_LINK_INVALID);
  check(flashbvh_workcell_move(&cell, link, &at.frame, UINT32_MAX) ==
        FLASHBVH_STATUS_DISTANCE_OUT_OF_RANGE);
  check(flashbvh_workcell_move(&cell, link, &skew.frame, 0) == FLASHBVH_STATUS_NOT_A_ROTATION);
  check(flashbvh_workcell_move(&cell, link, &off.frame, 0) ==
        FLASHBVH_STATUS_TRANSLATION_OUT_OF_RANGE);
  check(flashbvh_workcell_move(&cell, link, &at.frame, 0) == FLASHBVH_STATUS_DONE);
}

long robot_refusal_failures(void) {
  check_memory();
  check_values();
  check_bodies();
  return failures;
}
