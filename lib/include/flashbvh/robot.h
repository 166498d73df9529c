/* flashbvh for C: robots that can't hit themselves. robot/guard.hpp, motion.hpp, workcell.hpp and
 * kinematics.hpp say what is promised, what is the user's, and how it is done.
 *
 * A robot is a view of an image that `flashbvh robot` writes. A guard, a motion and a
 * workcell each are a small object and memory of the caller's, both of which stay where they are,
 * and outlive all that is made of them. Memory is an array of words of the size that a macro
 * returns; a guard's and a motion's is plain data without pointers:
 *
 *     static uint32_t state[FLASHBVH_GUARD_STATE_SIZE(JOINTS, PAIRS, PAIR_JOINTS) / 4];
 *     flashbvh_guard_init(&guard, &robot, state, sizeof state);
 *
 * Values: flashbvh_robot::variable_count of them. Distances and work are as in clearance.h and
 * flashbvh.h. Of the target flashbvh::robot.
 */
#ifndef FLASHBVH_ROBOT_H
#define FLASHBVH_ROBOT_H

#include "flashbvh/clearance.h"
#include "flashbvh/plain/robot_parts.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Robots: robot/robot.hpp and frame.hpp -------------------------------------------------------- */

/** What no joint takes: of a float that is no number, or too large. */
#define FLASHBVH_NO_COORDINATE INT32_MIN
/** Fraction bits of a frame's translation: a cell is 2,048. */
#define FLASHBVH_FRAME_BITS 11
/** Fraction bits of a reach. */
#define FLASHBVH_REACH_BITS 26
/** In place of a joint's number: the robot's root. */
#define FLASHBVH_BASE 0xFF
/** In place of a pair's number. */
#define FLASHBVH_NO_PAIR 0xFFFF
/** In place of a variable's number. */
#define FLASHBVH_NO_VARIABLE 0xFF

/* Read as the mesh that it is. */
#if defined(__GNUC__)
#define FLASHBVH_VIEW __attribute__((__may_alias__))
#else
#define FLASHBVH_VIEW
#endif

/** What is in a flashbvh_mesh: for constant arrays that `flashbvh robot --format c` writes. */
typedef struct FLASHBVH_VIEW flashbvh_mesh_view {
  const void* nodes;
  uint16_t node_count;
  uint16_t leaf_count;
  uint16_t stack_need;
  const void* triangles;
  const void* triangle_ids;
  const void* leaf_offsets;
  const void* vertices;
  const void* shell_vertices;
  uint16_t triangle_count;
  uint16_t vertex_count;
  uint16_t shell_count;
  uint16_t longest_edge;
  int32_t origin[3];
  uint8_t unit;
  bool is_closed;
  uint64_t cell_bits;
} flashbvh_mesh_view;

/* Images: robot/image.hpp ---------------------------------------------------------------------- */

/** open_robot(), of `NAME.robot`: `image` starts at a multiple of 4 and outlives `robot`, and so do
 * `meshes`, which may be written whatever the status; `robot` is on DONE alone. Statuses of
 * flashbvh_open(); IMAGE_TOO_LARGE: more than `mesh_capacity` links; CELL_MISMATCH. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_open_robot(const void* image, size_t size,
                                                       flashbvh_mesh* meshes,
                                                       uint32_t mesh_capacity,
                                                       flashbvh_robot* robot);

/** view_robot_unchecked(), of an image that `flashbvh robot` has written into the firmware's C. */
void flashbvh_view_robot_unchecked(const void* image, flashbvh_mesh* meshes, flashbvh_robot* robot);

/** robot_name(), joint_name(), link_name(): for people, of an image that was opened or baked. */
const char* flashbvh_robot_name(const void* image);
const char* flashbvh_joint_name(const void* image, uint32_t joint);
const char* flashbvh_link_name(const void* image, uint32_t link);

/** mount_count(), mounts(), mount_name(): where tools are fastened. */
uint32_t flashbvh_mount_count(const void* image);
const flashbvh_mount* flashbvh_mounts(const void* image);
const char* flashbvh_mount_name(const void* image, uint32_t mount);

/** unguarded_count(), unguarded_pairs(): what no guard looks at. */
uint32_t flashbvh_unguarded_count(const void* image);
const flashbvh_robot_unguarded* flashbvh_unguarded_pairs(const void* image);

/* Kinematics: robot/kinematics.hpp ------------------------------------------------------------- */

/** set_coordinates(): of all joints, joint_count, from the caller's values. NOT_A_COORDINATE;
 * JOINT_OUT_OF_LIMITS. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_set_coordinates(const flashbvh_robot* robot,
                                                            const flashbvh_joint_coordinate* values,
                                                            flashbvh_joint_coordinate* coordinates);

/** set_frames(): of all joints in the base's frame, joint_count of them. */
void flashbvh_set_frames(const flashbvh_robot* robot, const flashbvh_joint_coordinate* coordinates,
                         flashbvh_frame* frames);

/** composed(). `frame` may be one of the two. */
void flashbvh_frame_composed(const flashbvh_frame* outer, const flashbvh_frame* inner,
                             flashbvh_frame* frame);

/** relative_pose(). */
flashbvh_status flashbvh_relative_pose(const flashbvh_frame* a, const flashbvh_frame* b,
                                       flashbvh_pose* pose);

/* From floats, without float arithmetic: robot/robot_float.hpp --------------------------------- */

/** angle_coordinate(). FLASHBVH_NO_COORDINATE: no number, or 8 turns or more. */
flashbvh_joint_coordinate flashbvh_angle_coordinate(float radians);

/** slide_coordinate(). FLASHBVH_NO_COORDINATE: no number, or 2^19 cells or more. */
flashbvh_joint_coordinate flashbvh_slide_coordinate(float length, float cells_per_unit);

/** set_values(): radians, and metres of joints that slide. */
void flashbvh_set_values(const flashbvh_robot* robot, const float* floats,
                         flashbvh_joint_coordinate* values);

/** set_frame(): a matrix, row by row, and metres. TRANSLATION_OUT_OF_RANGE. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_set_frame_of_matrix(const flashbvh_robot* robot,
                                                                const float rotation[9],
                                                                const float metres[3],
                                                                flashbvh_frame* frame);

/** set_frame(): w, x, y, z, and metres. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_set_frame_of_quaternion(const flashbvh_robot* robot,
                                                                    const float rotation[4],
                                                                    const float metres[3],
                                                                    flashbvh_frame* frame);

/* The guard: robot/guard.hpp ------------------------------------------------------------------- */

/** PairDetail: where two links are near each other, and which way is out. */
typedef struct flashbvh_pair_detail {
  flashbvh_nearest_points nearest; /**< at the end of the period, in the base's frame */
  flashbvh_pair triangles;         /**< by their ids */
  flashbvh_witness witness;        /**< the same, as a hint of flashbvh_distance() */
  uint8_t variable;                /**< that has most to do with it, or FLASHBVH_NO_VARIABLE */
} flashbvh_pair_detail;

/** Guard, of one robot; what it knows lies in the state. */
FLASHBVH_OPAQUE(flashbvh_guard, 11, 16, void*);

/** Bytes of a guard's state: of a robot with so many joints and pairs, and joints between the links
 * of all pairs; or of one with fewer. A workcell's counts: those of its flashbvh_workcell_robot().
 */
#define FLASHBVH_GUARD_STATE_SIZE(joints, pairs, pair_joints) \
  (108 + 64 * (joints) + 16 * (pairs) + 4 * (pair_joints) + ((joints) + (pair_joints) + 3) / 4 * 4)

/** Knows nothing yet; the state is written. GUARD_STATE_INVALID, as of every later call: `size`, in
 * bytes, is too small, or the state does not start at a multiple of 4. */
flashbvh_status flashbvh_guard_init(flashbvh_guard* guard, const flashbvh_robot* robot, void* state,
                                    size_t size);

/** Guard::forget(). */
void flashbvh_guard_forget(flashbvh_guard* guard);

/** Guard::resume(), after the guard was made and the state copied back. GUARD_STATE_INVALID. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_guard_resume(flashbvh_guard* guard);

/** Guard::seal(), after each period. */
void flashbvh_guard_seal(flashbvh_guard* guard);

/** Guard::verify(), before the next one. GUARD_STATE_INVALID: memory is damaged. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_guard_verify(const flashbvh_guard* guard);

/** Guard::update(). NOT_A_COORDINATE, JOINT_OUT_OF_LIMITS, JOINT_JUMPED: the verdict is REFUSED,
 * and nothing changes. */
FLASHBVH_NODISCARD flashbvh_guard_answer flashbvh_guard_update(
    flashbvh_guard* guard, const flashbvh_joint_coordinate* values, uint32_t work);

/** Guard::go_on(): the period that it is in, with more work. */
FLASHBVH_NODISCARD flashbvh_guard_answer flashbvh_guard_go_on(flashbvh_guard* guard, uint32_t work);

/** Guard::prime(), at start-up. */
FLASHBVH_NODISCARD flashbvh_guard_answer
flashbvh_guard_prime(flashbvh_guard* guard, const flashbvh_joint_coordinate* values);

/** Guard::explain(); `changes`: variable_count of them. GUARD_STATE_INVALID: there was no period
 * yet, or no such pair. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_guard_explain(flashbvh_guard* guard, uint16_t pair,
                                                          int32_t* changes,
                                                          flashbvh_pair_detail* detail);

/** test_known_guard(), of robot/self_test.hpp. DONE or SELF_TEST_FAILED. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_test_known_guard(void);

/* Certified motions: robot/motion.hpp ---------------------------------------------------------- */

/** MotionQuery, of one motion at a time; where it stands lies in the state. */
FLASHBVH_OPAQUE(flashbvh_motion, 8, 0, void*);

/** Bytes of a motion's state: of a robot with so many variables and joints, or fewer. */
#define FLASHBVH_MOTION_STATE_SIZE(variables, joints) (104 + 12 * (variables) + 52 * (joints))

/** As flashbvh_guard_init(). The state is written by start and run. */
flashbvh_status flashbvh_motion_init(flashbvh_motion* motion, const flashbvh_robot* robot,
                                     void* state, size_t size);

/** MotionQuery::start(). NOT_A_COORDINATE; JOINT_OUT_OF_LIMITS. */
flashbvh_status flashbvh_motion_start(flashbvh_motion* motion,
                                      const flashbvh_joint_coordinate* from,
                                      const flashbvh_joint_coordinate* to);

/** MotionQuery::run(): at most `work`, overdrawn by one step; UINT32_MAX is all. */
FLASHBVH_NODISCARD flashbvh_motion_answer flashbvh_motion_run(flashbvh_motion* motion,
                                                              uint32_t work);

/** MotionQuery::set_values(): at numerator / 2^level of the way; level to 30. */
void flashbvh_motion_set_values(const flashbvh_motion* motion, uint32_t numerator, uint8_t level,
                                flashbvh_joint_coordinate* values);

/* Workcells: robot/workcell.hpp ---------------------------------------------------------------- */

/** Workcell: a robot in RAM, to which tools, obstacles and pairs are added. Not copied. */
FLASHBVH_OPAQUE(flashbvh_workcell, 11, 56, uint64_t);

/** Bytes of a workcell's memory: an array of uint64_t, as it has pointers and no size for all
 * cores. */
#define FLASHBVH_WORKCELL_SIZE(joints, links, pairs, reaches)                               \
  ((72 * (size_t)(joints) + (24 + sizeof(flashbvh_mesh)) * (links) + 16 * (size_t)(pairs) + \
    4 * (size_t)(reaches) + 7) /                                                            \
   8 * 8)

/** The robot alone. Its meshes outlive the workcell; `memory` is written. WORKCELL_FULL, as of
 * every later call that adds: `size`, in bytes, is too small for the room, or the room for the
 * robot; or `memory` does not start at a multiple of 8. */
flashbvh_status flashbvh_workcell_init(flashbvh_workcell* workcell, const flashbvh_robot* robot,
                                       void* memory, size_t size,
                                       const flashbvh_workcell_room* room);

/** Workcell::robot(): guards and motions are made of it afterwards. */
const flashbvh_robot* flashbvh_workcell_robot(const flashbvh_workcell* workcell);

/** Workcell::add(): `link` is written on DONE alone. WORKCELL_FULL; CELL_MISMATCH; LINK_INVALID;
 * NOT_A_ROTATION; TRANSLATION_OUT_OF_RANGE. What `mesh` is a view of outlives the workcell. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_workcell_add(flashbvh_workcell* workcell,
                                                         const flashbvh_mesh* mesh,
                                                         const flashbvh_mount* mount,
                                                         uint8_t* link);

/** Workcell::keep_apart(): distances in 1/256 cell. WORKCELL_FULL; LINK_INVALID;
 * DISTANCE_OUT_OF_RANGE. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_workcell_keep_apart(flashbvh_workcell* workcell,
                                                                uint8_t a, uint8_t b, uint32_t stop,
                                                                uint32_t warn);

/** Workcell::move(): `moved` in 1/256 cell. LINK_INVALID; DISTANCE_OUT_OF_RANGE; NOT_A_ROTATION;
 * TRANSLATION_OUT_OF_RANGE: it then stays where it was. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_workcell_move(flashbvh_workcell* workcell, uint8_t link,
                                                          const flashbvh_frame* frame,
                                                          uint32_t moved);

#ifdef __cplusplus
}
#endif

#endif
