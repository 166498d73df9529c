/* flashbvh for C: which triangles of one baked mesh intersect which triangles of another.
 *
 * A C99 face of the C++ library: the same meshes, queries, statuses and answers, in the same order.
 * Each function names its counterpart in C++, whose header says more. C++ alone has meshes of
 * 32-bit indices and the paper's traversals. Nothing is allocated or kept between calls, so any
 * number of queries may run at once, in interrupts too, as long as no two calls write the same
 * object.
 *
 * Lengths are in cells, the unit of the lattice that all meshes of one `flashbvh bake` share, where
 * nothing else is said.
 *
 * Pointers. Every object is the caller's. What an object points at outlives it, at the same
 * address: an image its mesh, two meshes and a pose their query. Null pointers are the caller's bug
 * and not looked for, except where a comment allows them; so is the use of an object before the
 * call that makes it. An object made here may be copied by assignment, a query too: the copy goes
 * on by itself.
 *
 * Stack on Cortex-M3 and M4 at -O2, in bytes (proofs/stack proves it): to open an image at
 * most 480, a run 592, a question in one call 736, a contact 496, the triangles of a pair 416, a
 * pose 416, a point in the unit 112.
 */
#ifndef FLASHBVH_FLASHBVH_H
#define FLASHBVH_FLASHBVH_H

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/plain/byte_order.h"
#include "flashbvh/plain/language.h"
#include "flashbvh/plain/points.h"
#include "flashbvh/plain/results.h"
#include "flashbvh/plain/run_costs.h"
#include "flashbvh/plain/run_cycles.h"
#include "flashbvh/status.h"
#include "flashbvh/version.hpp" /* macros alone: C as well as C++ */

#ifdef __cplusplus
extern "C" {
#endif

/* Meshes: image.hpp and mesh.hpp --------------------------------------------------------------- */

/** A baked mesh, opened: a view of its image. 64 bytes on a 32-bit core, 88 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_mesh, 6, 40, uint64_t);

/** open_image(): `image` starts at a multiple of 4 bytes. `mesh` is written only on DONE. Images of
 * pre-indexed meshes and of 32-bit indices give IMAGE_KIND. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_open(const void* image, size_t size,
                                                 flashbvh_mesh* mesh);

/** view_unchecked(), of an image that `flashbvh bake` has written into the firmware's C. */
void flashbvh_view_unchecked(const void* image, flashbvh_mesh* mesh);

/** Mesh::triangle_count. */
uint32_t flashbvh_mesh_triangles(const flashbvh_mesh* mesh);

/** Mesh::cell_bits: the cell in the unit, as the bits of an IEEE binary64. */
uint64_t flashbvh_mesh_cell(const flashbvh_mesh* mesh);

/** cells_per_unit(): for poses in the unit. */
float flashbvh_mesh_cells_per_unit(const flashbvh_mesh* mesh);

/** Of lengths: what the numbers of a mesh's file mean. */
typedef enum flashbvh_unit {
  FLASHBVH_UNIT_NONE = 0,
  FLASHBVH_UNIT_NM = 1,
  FLASHBVH_UNIT_UM = 2,
  FLASHBVH_UNIT_MM = 3,
  FLASHBVH_UNIT_CM = 4,
  FLASHBVH_UNIT_M = 5,
  FLASHBVH_UNIT_MIL = 6,
  FLASHBVH_UNIT_INCH = 7,
  FLASHBVH_UNIT_FOOT = 8
} flashbvh_unit;

/** Mesh::unit; NONE if `bake` was given none. */
flashbvh_unit flashbvh_mesh_unit(const flashbvh_mesh* mesh);

/** Mesh::origin. */
void flashbvh_mesh_origin(const flashbvh_mesh* mesh, int32_t origin[3]);

/** Mesh::is_closed. */
bool flashbvh_mesh_is_closed(const flashbvh_mesh* mesh);

/* Poses: pose.hpp and float.hpp ---------------------------------------------------------------- */

/** One in the fixed point of a rotation: 30 fraction bits. */
#define FLASHBVH_ROTATION_ONE ((int32_t)1 << 30)

/** A full turn, of an angle. */
#define FLASHBVH_FULL_TURN ((int32_t)1 << 28)

/** Largest magnitude of a translation, in cells. */
#define FLASHBVH_MAX_TRANSLATION ((int32_t)1 << 29)

/** Pose: B's point p lies at rotation * p + translation in A's frame. 68 bytes. An error is kept in
 * the pose, and every query on it returns it; so the makers' statuses may be left unread. */
typedef struct flashbvh_pose {
  union {
    unsigned char bytes[68];
    uint32_t word;
  } opaque;
} flashbvh_pose;

/** Pose::translated(), in cells. TRANSLATION_OUT_OF_RANGE. */
flashbvh_status flashbvh_pose_translated(int32_t x, int32_t y, int32_t z, flashbvh_pose* pose);

/** Pose::rigid(): `rotation` row by row; `fraction` in 1/65,536 of a cell, or null for nothing.
 * NOT_A_ROTATION; TRANSLATION_OUT_OF_RANGE. */
flashbvh_status flashbvh_pose_rigid(const int32_t rotation[9], const int32_t cells[3],
                                    const int16_t fraction[3], flashbvh_pose* pose);

/** pose_of(): `rotation` row by row, `translation` in the meshes' unit. Statuses as above. */
flashbvh_status flashbvh_pose_of_matrix(const float rotation[9], const float translation[3],
                                        float cells_per_unit, flashbvh_pose* pose);

/** pose_of(): `rotation` is w, x, y, z. */
flashbvh_status flashbvh_pose_of_quaternion(const float rotation[4], const float translation[3],
                                            float cells_per_unit, flashbvh_pose* pose);

/** Pose::composed(). `pose` may be one of the two. */
flashbvh_status flashbvh_pose_composed(const flashbvh_pose* outer, const flashbvh_pose* inner,
                                       flashbvh_pose* pose);

/** Pose::inverse(). `inverse` may be `pose`. */
flashbvh_status flashbvh_pose_inverse(const flashbvh_pose* pose, flashbvh_pose* inverse);

/** Pose::relative(). `pose` may be one of the two. */
flashbvh_status flashbvh_pose_relative(const flashbvh_pose* world_a, const flashbvh_pose* world_b,
                                       flashbvh_pose* pose);

/** Pose::status(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_pose_status(const flashbvh_pose* pose);

/** The numbers of a pose whose status is DONE, as flashbvh_pose_rigid() takes them. Each of the
 * arrays may be null. */
void flashbvh_pose_values(const flashbvh_pose* pose, int32_t rotation[9], int32_t cells[3],
                          int16_t fraction[3]);

/* Queries: query.hpp --------------------------------------------------------------------------- */

/** PairQuery, and all its memory. 128 bytes on a 32-bit core, 152 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_query, 6, 104, uint32_t);

/** Starts a query between A and B, which lies at `pose` in A's frame. SUSPENDED if there is
 * something to run. CELL_MISMATCH, or the pose's status, which every run returns again. */
flashbvh_status flashbvh_query_start(flashbvh_query* query, const flashbvh_mesh* a,
                                     const flashbvh_mesh* b, const flashbvh_pose* pose);

/** Query::status(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_query_status(const flashbvh_query* query);

/** Query::run(): does at most `work`, UINT32_MAX being all, and writes at most `capacity` pairs.
 * DONE; SUSPENDED: the work is done; FULL: the array is; or the query's error. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_query_run(flashbvh_query* query, uint32_t work,
                                                          flashbvh_pair* pairs, uint32_t capacity);

/** Takes a pair of triangles that intersect; false for no more. `context` is the caller's. */
typedef bool flashbvh_visitor(flashbvh_pair pair, void* context);

/** Query::run(): hands each pair to `visit`, until it returns false: FULL. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_query_visit(flashbvh_query* query, uint32_t work,
                                                            flashbvh_visitor* visit, void* context);

/** Query::stats(). */
flashbvh_stats flashbvh_query_stats(const flashbvh_query* query);

/** Query::last_pair(): after a run that wrote a pair and returned FULL, and inside a visitor. */
void flashbvh_query_last_pair(const flashbvh_query* query, flashbvh_triangle* a,
                              flashbvh_triangle* b);

/** Query::cursor(), between runs. */
flashbvh_cursor flashbvh_query_cursor(const flashbvh_query* query);

/** Query::resume(), of a started query. SUSPENDED or DONE, as the other query was;
 * CURSOR_INVALID, and nothing changes; or the query's own error. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_query_resume(flashbvh_query* query,
                                                         const flashbvh_cursor* cursor);

/* Contacts: contact.hpp ------------------------------------------------------------------------ */

/** contact_of(), of two triangles that intersect. */
void flashbvh_contact_of(const flashbvh_triangle* a, const flashbvh_triangle* b,
                         flashbvh_contact* contact);

/** contact_of_last(), where flashbvh_query_last_pair() may be called. */
void flashbvh_query_last_contact(const flashbvh_query* query, flashbvh_contact* contact);

/** transform_pair(). False, and nothing is written, if the pose is in error, the cells differ or an
 * id isn't in its mesh. */
FLASHBVH_NODISCARD bool flashbvh_transform_pair(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                                const flashbvh_pose* pose, flashbvh_pair pair,
                                                flashbvh_triangle* of_a, flashbvh_triangle* of_b);

/** in_unit(): a point in the mesh's unit, to the nearest floats. */
void flashbvh_in_unit(const flashbvh_fine_point* point, const flashbvh_mesh* mesh, float at[3]);

/** millionths_of(), of each coordinate; INT64_MAX or its negative where that is too small. */
void flashbvh_in_millionths(const flashbvh_fine_point* point, const flashbvh_mesh* mesh,
                            int64_t at[3]);

/* Time: time_bound.hpp; lib/docs/bounded_time.md has the proof --------------------------------- */

/** tree_size_of(), of an image that flashbvh_open() has opened; else why it is no image. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_image_tree_size(const void* image, size_t size,
                                                            flashbvh_tree_size* tree);

/* flashbvh_cortex_m0 to flashbvh_rv32imac. NOLINTBEGIN(readability-identifier-naming) */
#define FLASHBVH_CONSTANT(core, c_name, ...) extern const flashbvh_run_costs flashbvh_##c_name;
FLASHBVH_FOR_EACH_CORE(FLASHBVH_CONSTANT)
#undef FLASHBVH_CONSTANT
/* flashbvh_cortex_m0_cycles to flashbvh_cortex_m4f_cycles. */
#define FLASHBVH_CONSTANT(core, c_name, ...) \
  extern const flashbvh_run_cycles flashbvh_##c_name##_cycles;
FLASHBVH_FOR_EACH_CORE_IN_CYCLES(FLASHBVH_CONSTANT)
#undef FLASHBVH_CONSTANT
/* NOLINTEND(readability-identifier-naming) */

/** work_within(): the most work for which a run stays within so many instructions; 0 if none. */
uint32_t flashbvh_work_within(uint64_t instructions, const flashbvh_run_costs* costs,
                              const flashbvh_tree_size* a, const flashbvh_tree_size* b);

/** most_instructions(), of a run; not of UINT32_MAX, which is no limit. */
uint64_t flashbvh_most_instructions(const flashbvh_run_costs* costs, const flashbvh_tree_size* a,
                                    const flashbvh_tree_size* b, uint32_t work);

/** work_within(): of so many cycles, where a read of flash takes `wait_states`, at most 1000. */
uint32_t flashbvh_work_within_cycles(uint64_t cycles, const flashbvh_run_cycles* core,
                                     uint32_t wait_states, const flashbvh_tree_size* a,
                                     const flashbvh_tree_size* b);

/** most_cycles(), of a run; arguments as of flashbvh_work_within_cycles(). */
uint64_t flashbvh_most_cycles(const flashbvh_run_cycles* core, uint32_t wait_states,
                              const flashbvh_tree_size* a, const flashbvh_tree_size* b,
                              uint32_t work);

/** most_work(), of a whole query in one run. */
uint64_t flashbvh_most_work(const flashbvh_tree_size* a, const flashbvh_tree_size* b);

/** largest_step(): a run may overdraw by it, less 1. */
uint64_t flashbvh_largest_step(const flashbvh_tree_size* a, const flashbvh_tree_size* b);

/* One question, one call: collide.hpp ----------------------------------------------------------
 *
 * Each runs a query of its own, on the stack, to its end and returns DONE or the query's error,
 * FULL where said. After an error `yes` is true, since what can't be decided may collide, and
 * numbers are 0. */

/** intersects(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_intersects(const flashbvh_mesh* a,
                                                       const flashbvh_mesh* b,
                                                       const flashbvh_pose* pose, bool* yes);

/** Witness: two triangles, as a later query begins with them. May be stored. */
typedef struct flashbvh_witness {
  uint16_t a;
  uint16_t b;
} flashbvh_witness;

/** One that is none, to begin with. */
#define FLASHBVH_NO_WITNESS \
  { UINT16_MAX, UINT16_MAX }

/** intersects() with a hint, the pair that intersected last; at first FLASHBVH_NO_WITNESS.
 * HINT_INVALID: it is no pair of these meshes' triangles. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_intersects_hinted(const flashbvh_mesh* a,
                                                              const flashbvh_mesh* b,
                                                              const flashbvh_pose* pose,
                                                              flashbvh_witness* hint, bool* yes);

/** first_pair(); `found` is written only if there is one. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_first_pair(const flashbvh_mesh* a,
                                                       const flashbvh_mesh* b,
                                                       const flashbvh_pose* pose, bool* yes,
                                                       flashbvh_pair* found);

/** count_pairs(): `count` of the result. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_count_pairs(const flashbvh_mesh* a,
                                                            const flashbvh_mesh* b,
                                                            const flashbvh_pose* pose);

/** find_pairs(). DONE: these are all; FULL: there may be more. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_find_pairs(const flashbvh_mesh* a,
                                                           const flashbvh_mesh* b,
                                                           const flashbvh_pose* pose,
                                                           flashbvh_pair* pairs, uint32_t capacity);

/** UnitContact: the first pair of triangles that intersect, and where. */
typedef struct flashbvh_unit_contact {
  flashbvh_normal normal_a;
  flashbvh_normal normal_b;
  flashbvh_unit_point ends[2]; /**< of the common part, in A's frame and unit */
  flashbvh_pair triangles;
  bool yes; /**< false: no triangles intersect, and nothing else holds */
} flashbvh_unit_contact;

/** first_contact(). After an error `yes` is true and nothing else holds. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_first_contact(const flashbvh_mesh* a,
                                                          const flashbvh_mesh* b,
                                                          const flashbvh_pose* pose,
                                                          flashbvh_unit_contact* contact);

/** for_each_pair(), until `visit` returns false: FULL. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_for_each_pair(const flashbvh_mesh* a,
                                                          const flashbvh_mesh* b,
                                                          const flashbvh_pose* pose,
                                                          flashbvh_visitor* visit, void* context);

#ifdef __cplusplus
}
#endif

#endif
