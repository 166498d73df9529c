/* flashbvh for C: robots that cannot hit themselves. robot/guard.hpp, motion.hpp, workcell.hpp and
 * kinematics.hpp describe the guarantees, the user's part and the methods.
 *
 * A robot is a view of an image that `flashbvh robot` writes. A guard, a motion or a workcell is a
 * small object and memory of the caller's. Both must not move, and must outlive all objects made
 * from them. The memory is an array of words of the size that a macro returns. A guard's and a
 * motion's memory is plain data without pointers:
 *
 *     static uint32_t state[FLASHBVH_GUARD_STATE_SIZE(JOINTS, PAIRS, PAIR_JOINTS) / 4];
 *     flashbvh_guard_init(&guard, &robot, state, sizeof state);
 *
 * Values: flashbvh_robot::variable_count of them. Distances and work are as in
 * flashbvh.h. NOT_OPEN, from every call of a guard, a motion or a workcell: its robot was not
 * opened. In the target flashbvh::robot. */
#pragma once

#include "flashbvh/flashbvh.h"
#include "flashbvh/plain/robot_parts.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Robots: robot/robot.hpp and pose.hpp --------------------------------------------------------- */

/** An invalid coordinate: the result for a float that is not a number, or too large. */
#define FLASHBVH_NO_COORDINATE INT32_MIN
/** Fraction bits of a frame's translation: 2,048 units are one cell. */
#define FLASHBVH_FRAME_BITS 11
/** Fraction bits of a reach. */
#define FLASHBVH_REACH_BITS 26
/** In place of a joint's number: the base, the robot's root. */
#define FLASHBVH_BASE 0xFF
/** In place of a pair's number: all pairs are free. */
#define FLASHBVH_NO_PAIR 0xFFFF
/** In place of a variable's number: no variable. */
#define FLASHBVH_NO_VARIABLE 0xFF

/* Images: robot/image.hpp ---------------------------------------------------------------------- */

/** open_robot(), for `NAME.robot`: `image` must start at a multiple of 4. `image` and `meshes` must
 * outlive `robot`. `meshes` may be written for every status, `robot` only on DONE. Statuses of
 * flashbvh_open(); IMAGE_TOO_LARGE: more than `mesh_capacity` links; CELL_MISMATCH. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_open_robot(const void* image, size_t size,
                                                       flashbvh_mesh* meshes,
                                                       uint32_t mesh_capacity,
                                                       flashbvh_robot* robot);

/** view_robot_unchecked(), for an image that `flashbvh robot` has written into the firmware's C. */
void flashbvh_view_robot_unchecked(const void* image, flashbvh_mesh* meshes, flashbvh_robot* robot);

/** joint_name(), link_name(): for people, from an image that was opened or baked. */
const char* flashbvh_joint_name(const void* image, uint32_t joint);
const char* flashbvh_link_name(const void* image, uint32_t link);

/** mounts(), mount_count(): the frames for mounting tools. `count` may be null; the robot's header
 * has the mounts' numbers. */
const flashbvh_mount* flashbvh_mounts(const void* image, uint32_t* count);

/** unguarded_pairs(), unguarded_count(): the pairs of links that no guard checks. */
const flashbvh_robot_unguarded* flashbvh_unguarded_pairs(const void* image, uint32_t* count);

/* From floats, without float arithmetic: robot/robot_float.hpp --------------------------------- */

/** set_values(): radians, and metres for prismatic joints. FLASHBVH_NO_COORDINATE, which each
 * period and motion refuses: not a number, or 8 turns or 2^19 cells or more. */
void flashbvh_set_values(const flashbvh_robot* robot, const float* floats,
                         flashbvh_joint_coordinate* values);

/** set_frame(): a matrix, row by row, and metres. TRANSLATION_OUT_OF_RANGE. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_set_frame_of_matrix(const flashbvh_robot* robot,
                                                                const float rotation[9],
                                                                const float metres[3],
                                                                flashbvh_frame* frame);

/* The guard: robot/guard.hpp ------------------------------------------------------------------- */

/** PairDetail: the nearest points of two links, and the direction that separates them. */
typedef struct flashbvh_pair_detail {
  flashbvh_nearest_points nearest; /**< at the end of the period, in the base's frame */
  flashbvh_pair triangles;         /**< by their ids */
  flashbvh_witness witness;        /**< these triangles as a hint for flashbvh_distance() */
  uint8_t variable; /**< the variable with the largest share, or FLASHBVH_NO_VARIABLE */
} flashbvh_pair_detail;

/** Guard of one robot. All its certificates are in the state. */
FLASHBVH_OPAQUE(flashbvh_guard, 13, 16, void*);

/** Bytes of a guard's state, for at most these numbers of joints and pairs, and of joints between
 * the links of all pairs. For a workcell: the counts of its flashbvh_workcell_robot(). */
#define FLASHBVH_GUARD_STATE_SIZE(joints, pairs, pair_joints) \
  (124 + 72 * (joints) + 28 * (pairs) + 4 * (pair_joints) + ((joints) + (pair_joints) + 3) / 4 * 4)

/** Starts without certificates; the state is written. GUARD_STATE_INVALID, as from every later
 * call: `size`, in bytes, is too small, or the state does not start at a multiple of 4. */
flashbvh_status flashbvh_guard_init(flashbvh_guard* guard, const flashbvh_robot* robot, void* state,
                                    size_t size);

/** Guard::seal(). Call it after each period. */
void flashbvh_guard_seal(flashbvh_guard* guard);

/** Guard::verify(). Call it before the next period. GUARD_STATE_INVALID: memory is damaged. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_guard_verify(const flashbvh_guard* guard);

/** Guard::update(). At start-up, while the robot stands still, with UINT32_MAX as `work`: no limit.
 * NOT_A_COORDINATE, JOINT_OUT_OF_LIMITS, JOINT_JUMPED: the verdict is REFUSED, and nothing changes.
 */
FLASHBVH_NODISCARD flashbvh_guard_answer flashbvh_guard_update(
    flashbvh_guard* guard, const flashbvh_joint_coordinate* values, uint32_t work);

/** Guard::go_on(): continues the current period with more work. */
FLASHBVH_NODISCARD flashbvh_guard_answer flashbvh_guard_go_on(flashbvh_guard* guard, uint32_t work);

/** Guard::limit(): sets `granted` to the part of a command that brings no pair nearer than it may.
 * `wanted` and `granted` have variable_count entries. */
FLASHBVH_NODISCARD flashbvh_limit_answer
flashbvh_guard_limit(flashbvh_guard* guard, const flashbvh_joint_coordinate* wanted,
                     flashbvh_joint_coordinate* granted, uint32_t work);

/** Guard::release(): lets a pair that intersects move, by at most this in each command.
 * GUARD_STATE_INVALID, DISTANCE_OUT_OF_RANGE. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_guard_release(flashbvh_guard* guard, uint16_t pair,
                                                          flashbvh_fine_length a_command);

/** Guard::explain(); `changes` has variable_count entries. GUARD_STATE_INVALID: there was no period
 * yet, or no such pair. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_guard_explain(flashbvh_guard* guard, uint16_t pair,
                                                          int32_t* changes,
                                                          flashbvh_pair_detail* detail);

/* Certified motions: robot/motion.hpp ---------------------------------------------------------- */

/** MotionQuery of one motion at a time. Its cursor is in the state. */
FLASHBVH_OPAQUE(flashbvh_motion, 8, 0, void*);

/** Bytes of a motion's state, for at most these numbers of variables and joints. */
#define FLASHBVH_MOTION_STATE_SIZE(variables, joints) (104 + 12 * (variables) + 52 * (joints))

/** As flashbvh_guard_init(). Start and run write the state. */
flashbvh_status flashbvh_motion_init(flashbvh_motion* motion, const flashbvh_robot* robot,
                                     void* state, size_t size);

/** MotionQuery::start(). NOT_A_COORDINATE; JOINT_OUT_OF_LIMITS. */
flashbvh_status flashbvh_motion_start(flashbvh_motion* motion,
                                      const flashbvh_joint_coordinate* from,
                                      const flashbvh_joint_coordinate* to);

/** MotionQuery::run(): does at most `work`, overdrawn by one step; UINT32_MAX: no limit. */
FLASHBVH_NODISCARD flashbvh_motion_answer flashbvh_motion_run(flashbvh_motion* motion,
                                                              uint32_t work);

/* Workcells: robot/workcell.hpp ---------------------------------------------------------------- */

/** Workcell: a robot in RAM, to which tools, obstacles and pairs are added. Not copied. */
FLASHBVH_OPAQUE(flashbvh_workcell, 11, 56, uint64_t);

/** Bytes of a workcell's memory: an array of uint64_t, since it has pointers and its size differs
 * between cores. */
#define FLASHBVH_WORKCELL_SIZE(joints, links, pairs, reaches)                 \
  ((sizeof(uint64_t[9]) * (joints) + (24 + sizeof(flashbvh_mesh)) * (links) + \
    sizeof(uint64_t[2]) * (pairs) + sizeof(uint32_t[1]) * (reaches) + 7) /    \
   8 * 8)

/** Starts with the robot only. Its meshes must outlive the workcell; `memory` is written.
 * NOT_OPEN; WORKCELL_FULL, as from every later call that adds: `size`, in bytes, is too small for
 * the capacity `room`, or `room` for the robot; or `memory` does not start at a multiple of 8. */
flashbvh_status flashbvh_workcell_init(flashbvh_workcell* workcell, const flashbvh_robot* robot,
                                       void* memory, size_t size,
                                       const flashbvh_workcell_room* room);

/** Workcell::robot(): make guards and motions of it after adding. */
const flashbvh_robot* flashbvh_workcell_robot(const flashbvh_workcell* workcell);

/** Workcell::add(): `link` is written only on DONE. NOT_OPEN: the robot or `mesh`; WORKCELL_FULL;
 * CELL_MISMATCH; LINK_INVALID; NOT_A_ROTATION; TRANSLATION_OUT_OF_RANGE; DISTANCE_OUT_OF_RANGE. The
 * arrays of `mesh` must outlive the workcell. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_workcell_add(flashbvh_workcell* workcell,
                                                         const flashbvh_mesh* mesh,
                                                         const flashbvh_mount* mount,
                                                         uint8_t* link);

/** Workcell::keep_apart(). NOT_OPEN; WORKCELL_FULL; LINK_INVALID; DISTANCE_OUT_OF_RANGE. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_workcell_keep_apart(flashbvh_workcell* workcell,
                                                                uint8_t a, uint8_t b,
                                                                flashbvh_fine_length stop,
                                                                flashbvh_fine_length warn);

/** Workcell::move(). A guard rejects periods, JOINT_JUMPED, once an obstacle has moved by 2^31
 * since the last accepted one. NOT_OPEN, LINK_INVALID, DISTANCE_OUT_OF_RANGE, NOT_A_ROTATION,
 * TRANSLATION_OUT_OF_RANGE: the obstacle then stays where it was. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_workcell_move(flashbvh_workcell* workcell, uint8_t link,
                                                          const flashbvh_frame* frame,
                                                          flashbvh_fine_length moved);

#ifdef __cplusplus
}
#endif
