/* A robot's story, told in C and in C++: all that guards, motions and workcells answer, as a hash,
 * and whether both tell the same. */
#ifndef FLASHBVH_TESTS_C_API_ROBOT_H
#define FLASHBVH_TESTS_C_API_ROBOT_H

#include "flashbvh/robot.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Of the arm of firmware_examples/robot_guard: turn, shoulder, elbow, roll. */
enum { VARIABLES = 4, MOTIONS = 3, PERIODS = 40, GUARD_WORK = 40, MOTION_WORK = 60 };

/** Room for a tool on the last joint and a ball in the base's frame. */
enum { ROOM_JOINTS = 6, ROOM_LINKS = 8, ROOM_PAIRS = 11, ROOM_REACHES = 16, ROOM_PAIR_JOINTS = 41 };

/** Memory for one user at a time: a workcell and the state of its guard. Small boards have no more.
 */
enum {
  CELL_WORDS = FLASHBVH_WORKCELL_SIZE(ROOM_JOINTS, ROOM_LINKS, ROOM_PAIRS, ROOM_REACHES) / 8,
  CROWDED_BYTES = FLASHBVH_GUARD_STATE_SIZE(ROOM_JOINTS, ROOM_PAIRS, ROOM_PAIR_JOINTS),
  SCRATCH_WORDS = CELL_WORDS + CROWDED_BYTES / 8
};
extern uint64_t scratch[SCRATCH_WORDS];

/** Distances, in 1/256 cell: 5 and 30 mm. */
enum { STOP_FINE = 40328, WARN_FINE = 241964 };

/** What was told so far. */
typedef struct story {
  uint32_t hash;
  uint32_t count;
  uint32_t verdicts[5]; /**< how many of each, to tell that all came up */
  uint32_t outcomes[3];
} story;

void tell(story* to, uint32_t word);
void tell_answer(story* to, flashbvh_guard_answer answer);
void tell_detail(story* to, const flashbvh_pair_detail* detail, const int32_t* changes);
void tell_motion(story* to, flashbvh_motion_answer answer);
void tell_words(story* to, const void* words, uint32_t count);

/** Where a motion begins, and ends. */
extern const float motion_ends[MOTIONS][2][VARIABLES];
/** The set point after so many periods. */
void set_point(int motion, int period, float joints[VARIABLES]);
/** Where the ball is then, row by row and in metres. */
void set_ball(int period, float rotation[9], float metres[3]);
/** What the ball moves in a period, at most, in 1/256 cell. */
enum { BALL_MOVED = 2 * 8064 };

void kinematics_in_cpp(story* to);
void guard_in_cpp(int motion, story* to);
void workcell_in_cpp(int motion, story* to);
void motion_in_cpp(int motion, story* to);

/** Whether each array of the robot baked in C has what that in C++ has. */
bool is_robot_of_cpp(const flashbvh_robot* robot);
/** Takes up a state that a guard in C left, and tells the next period. */
void resume_in_cpp(const void* state, uint32_t size, story* to);

/** How many of the checks of what is refused failed. */
long robot_refusal_failures(void);

#ifdef __cplusplus
}
#endif

#endif
