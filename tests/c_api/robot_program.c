/* A program in C with a robot: kinematics, guards, a tool and an obstacle, certified motions. C++
 * does the same with the same robot and has to tell the same story. */
#include "robot.h"

#include <string.h>

#include "c_arm.robot.h"
#include "text.h"

static long failures;

static uint32_t state[c_arm_GUARD_STATE_SIZE / 4];

static void check(bool holds, const char* what, long where) {
  if (!holds) {
    ++failures;
    port_put(what);
    port_put(", ");
    port_put_number(where);
    port_put("\n");
  }
}

static void check_same(const story* p, const story* q, const char* what, long where) {
  check(p->hash == q->hash && p->count == q->count && p->count != 0, what, where);
}

static void values_at(int motion, int period, flashbvh_joint_coordinate* values) {
  float joints[VARIABLES];
  set_point(motion, period, joints);
  flashbvh_set_values(&c_arm_robot, joints, values);
}

static void kinematics_in_c(story* to) {
  const float q[4] = {0.8f, 0, 0.6f, 0};
  const float at[3] = {0.1f, -0.2f, 0.3f};
  flashbvh_joint_coordinate coordinates[c_arm_JOINT_COUNT];
  flashbvh_frame frames[c_arm_JOINT_COUNT];
  flashbvh_joint_coordinate values[VARIABLES];
  int32_t numbers[9];
  flashbvh_pose pose;
  flashbvh_frame turned;
  for (int period = 0; period <= PERIODS; period += 8) {
    values_at(0, period, values);
    tell(to, (uint32_t)flashbvh_set_coordinates(&c_arm_robot, values, coordinates));
    flashbvh_set_frames(&c_arm_robot, coordinates, frames);
    tell_words(to, coordinates, c_arm_JOINT_COUNT);
    tell_words(to, frames, c_arm_JOINT_COUNT * sizeof frames[0] / 4);
    tell(to, (uint32_t)flashbvh_set_frame_of_quaternion(&c_arm_robot, q, at, &turned));
    flashbvh_frame_composed(&turned, &frames[3], &turned);
    tell_words(to, &turned, sizeof turned / 4);
    tell(to, (uint32_t)flashbvh_relative_pose(&frames[0], &turned, &pose));
    flashbvh_pose_values(&pose, numbers, NULL, NULL);
    tell_words(to, numbers, 9);
    flashbvh_pose_values(&pose, NULL, numbers, NULL);
    tell_words(to, numbers, 3);
  }
  tell(to, (uint32_t)flashbvh_angle_coordinate(-2.5f));
  tell(to, (uint32_t)flashbvh_slide_coordinate(0.25f, c_arm_CELLS_PER_UNIT));
}

/** To the end, if it is not known. */
static flashbvh_guard_answer tell_period(flashbvh_guard* guard, int motion, int period, story* to) {
  flashbvh_joint_coordinate values[VARIABLES];
  flashbvh_guard_answer answer;
  values_at(motion, period, values);
  answer = flashbvh_guard_update(guard, values, GUARD_WORK);
  tell_answer(to, answer);
  if (answer.verdict == FLASHBVH_VERDICT_NOT_YET_KNOWN) {
    answer = flashbvh_guard_go_on(guard, UINT32_MAX);
    tell_answer(to, answer);
  }
  return answer;
}

static void tell_explained(flashbvh_guard* guard, uint16_t pair, story* to) {
  int32_t changes[VARIABLES];
  flashbvh_pair_detail detail;
  tell(to, (uint32_t)flashbvh_guard_explain(guard, pair, changes, &detail));
  tell_detail(to, &detail, changes);
}

/** Periods along a motion. */
static void guard_in_c(int motion, story* to) {
  flashbvh_joint_coordinate values[VARIABLES];
  flashbvh_guard_answer answer;
  flashbvh_guard guard;
  (void)flashbvh_guard_init(&guard, &c_arm_robot, state, sizeof state);
  values_at(motion, 0, values);
  answer = flashbvh_guard_prime(&guard, values);
  tell_answer(to, answer);
  for (int period = 1; period <= PERIODS; ++period) {
    answer = tell_period(&guard, motion, period, to);
  }
  tell_explained(&guard, answer.pair, to);
}

/** The state goes to C++, and, through a copy, to another guard in C. */
static void check_resumed(void) {
  void* const kept = scratch;
  story c = {0};
  story cpp = {0};
  flashbvh_joint_coordinate values[VARIABLES];
  flashbvh_guard guard;
  memcpy(kept, state, sizeof state);
  resume_in_cpp(kept, sizeof state, &cpp);
  (void)flashbvh_guard_init(&guard, &c_arm_robot, state, sizeof state);
  memcpy(state, kept, sizeof state);
  tell(&c, (uint32_t)flashbvh_guard_resume(&guard));
  values_at(MOTIONS - 1, PERIODS - 1, values);
  tell_answer(&c, flashbvh_guard_update(&guard, values, GUARD_WORK));
  check_same(&c, &cpp, "a state taken up", 0);
  state[1] ^= 1;
  check(flashbvh_guard_resume(&guard) == FLASHBVH_STATUS_GUARD_STATE_INVALID, "damage", 0);
  check(flashbvh_guard_update(&guard, values, UINT32_MAX).status == FLASHBVH_STATUS_DONE, "damage",
        1);
  flashbvh_guard_forget(&guard);
  check(flashbvh_guard_go_on(&guard, 1).status == FLASHBVH_STATUS_GUARD_STATE_INVALID, "forget", 0);
}

static flashbvh_status put_ball(int period, flashbvh_frame* frame) {
  float rotation[9];
  float metres[3];
  set_ball(period, rotation, metres);
  return flashbvh_set_frame_of_matrix(&c_arm_robot, rotation, metres, frame);
}

/** A second gripper as a tool in the first one, and the turret's mesh as a ball that goes up. */
static void workcell_in_c(int motion, story* to) {
  const flashbvh_workcell_room room = {ROOM_JOINTS, ROOM_LINKS, ROOM_PAIRS, ROOM_REACHES};
  flashbvh_joint_coordinate values[VARIABLES];
  flashbvh_workcell cell;
  flashbvh_mount ball_at = {FLASHBVH_BASE, {{{0}}, {0}}};
  flashbvh_guard guard;
  flashbvh_guard_answer answer;
  uint8_t tool = 0;
  uint8_t ball = 0;
  tell(to, (uint32_t)flashbvh_workcell_init(&cell, &c_arm_robot, scratch, 8 * CELL_WORDS, &room));
  tell(to, (uint32_t)flashbvh_workcell_add(&cell, &c_arm_robot.meshes[c_arm_link_gripper],
                                           &c_arm_mount_gripper, &tool));
  tell(to, (uint32_t)put_ball(0, &ball_at.frame));
  tell(to, (uint32_t)flashbvh_workcell_add(&cell, &c_arm_robot.meshes[c_arm_link_turret], &ball_at,
                                           &ball));
  for (uint8_t link = c_arm_link_upper_arm; link <= tool; ++link) {
    tell(to, (uint32_t)flashbvh_workcell_keep_apart(&cell, link, ball, STOP_FINE, WARN_FINE));
  }
  tell(to, (uint32_t)flashbvh_workcell_keep_apart(&cell, c_arm_link_base, tool, 0, WARN_FINE));
  tell(to, flashbvh_workcell_robot(&cell)->hash);
  tell(to, flashbvh_workcell_robot(&cell)->slack);
  tell(to, (uint32_t)flashbvh_guard_init(&guard, flashbvh_workcell_robot(&cell),
                                         scratch + CELL_WORDS, CROWDED_BYTES));
  values_at(motion, 0, values);
  tell_answer(to, flashbvh_guard_prime(&guard, values));
  for (int period = 1; period <= PERIODS; ++period) {
    tell(to, (uint32_t)put_ball(period, &ball_at.frame));
    tell(to, (uint32_t)flashbvh_workcell_move(&cell, ball, &ball_at.frame, BALL_MOVED));
    answer = tell_period(&guard, motion, period, to);
    if (period % 8 == 0 && answer.pair != FLASHBVH_NO_PAIR) {
      tell_explained(&guard, answer.pair, to);
    }
  }
}

static void motion_in_c(int motion, story* to) {
  flashbvh_joint_coordinate from[VARIABLES];
  flashbvh_joint_coordinate at[VARIABLES];
  flashbvh_motion query;
  flashbvh_motion_answer answer;
  values_at(motion, 0, from);
  values_at(motion, PERIODS, at);
  tell(to, (uint32_t)flashbvh_motion_init(&query, &c_arm_robot, scratch, c_arm_MOTION_STATE_SIZE));
  tell(to, (uint32_t)flashbvh_motion_start(&query, from, at));
  do {
    answer = flashbvh_motion_run(&query, MOTION_WORK);
    tell_motion(to, answer);
  } while (answer.status == FLASHBVH_STATUS_SUSPENDED);
  flashbvh_motion_set_values(&query, answer.numerator, answer.level, at);
  tell_words(to, at, VARIABLES);
}

typedef void teller(int motion, story* to);

/** All motions; every verdict, or every outcome but CLOSE, comes up where it is asked for. */
static void check_stories(teller* in_c, teller* in_cpp, int verdicts, int outcomes,
                          const char* what) {
  story all = {0};
  for (int motion = 0; motion < MOTIONS; ++motion) {
    story c = {0};
    story cpp = {0};
    in_c(motion, &c);
    in_cpp(motion, &cpp);
    check_same(&c, &cpp, what, motion);
    for (int i = 0; i < 4; ++i) {
      all.verdicts[i] += c.verdicts[i];
    }
    for (int i = 0; i < 3; ++i) {
      all.outcomes[i] += c.outcomes[i];
    }
  }
  for (int i = 0; i < verdicts; ++i) {
    check(all.verdicts[i] != 0, what, MOTIONS + i);
  }
  for (int i = 0; i < outcomes; ++i) {
    check(all.outcomes[i] != 0, what, MOTIONS + i);
  }
}

extern const unsigned char robot_image[];
extern const unsigned char robot_image_end[];

/** Opened in place, it is the robot that was baked as arrays. */
static void check_image(void) {
  static flashbvh_mesh meshes[c_arm_LINK_COUNT];
  const size_t size = (size_t)(robot_image_end - robot_image);
  flashbvh_robot robot;
  check(flashbvh_open_robot(robot_image, size - 1, meshes, c_arm_LINK_COUNT, &robot) ==
            FLASHBVH_STATUS_IMAGE_TRUNCATED,
        "image", 0);
  check(flashbvh_open_robot(robot_image, size, meshes, c_arm_LINK_COUNT - 1, &robot) ==
            FLASHBVH_STATUS_IMAGE_TOO_LARGE,
        "image", 1);
  check(flashbvh_open_robot(robot_image, size, meshes, c_arm_LINK_COUNT, &robot) ==
            FLASHBVH_STATUS_DONE,
        "image", 2);
  check(is_robot_of_cpp(&robot), "image", 3);
  check(strcmp(flashbvh_robot_name(robot_image), "i_arm") == 0, "image", 4);
  check(strcmp(flashbvh_mount_name(robot_image, 0), "base") == 0, "image", 5);
  const flashbvh_mount* const mount = flashbvh_mounts(robot_image);
  check(mount->joint == c_arm_mount_base.joint &&
            memcmp(&mount->frame, &c_arm_mount_base.frame, sizeof mount->frame) == 0,
        "image", 6);
  check(flashbvh_unguarded_count(robot_image) == c_arm_UNGUARDED_COUNT, "image", 7);
  check((const void*)flashbvh_unguarded_pairs(robot_image) ==
            (const void*)(mount + flashbvh_mount_count(robot_image)),
        "image", 8);
}

int main(void) {
  story c = {0};
  story cpp = {0};
  check(is_robot_of_cpp(&c_arm_robot), "robot", 0);
  check_image();
  kinematics_in_c(&c);
  kinematics_in_cpp(&cpp);
  check_same(&c, &cpp, "kinematics", 0);
  check_stories(guard_in_c, guard_in_cpp, 4, 0, "guard");
  check_resumed();
  check_stories(workcell_in_c, workcell_in_cpp, 4, 0, "workcell");
  check_stories(motion_in_c, motion_in_cpp, 0, 2, "motion");
  failures += robot_refusal_failures();
  port_put("failures: ");
  port_put_number(failures);
  port_put("\n");
  return failures == 0 ? 0 : 1;
}
