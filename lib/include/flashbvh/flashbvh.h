/* flashbvh for C: finds the triangles of two baked meshes that intersect.
 *
 * A C99 interface to the C++ library, with equal meshes, queries, statuses and answers in equal
 * order. Each comment names the C++ counterpart, whose header has the details. Only C++ has meshes
 * with 32-bit indices. No call allocates or keeps memory. So any number
 * of queries may run at once, in interrupts too, if no two calls write to one object.
 *
 * Unless stated otherwise, lengths are in cells: the unit of the lattice that all meshes of one
 * `flashbvh bake` share.
 *
 * Pointers. The caller owns every object. The target of a pointer in an object must outlive the
 * object, at one address: an image its mesh, two meshes and a pose their query. Null pointers are
 * the caller's error and not checked, unless a comment allows them. An object must not be used
 * before the call that makes it. Objects may be copied by assignment, queries too: a copy runs on
 * its own.
 *
 * Stack on Cortex-M3 and M4 at -O2, in bytes (proofs/stack proves it): opening an image at most
 * 480, a run 592, a query in one call 736, a contact 496, the triangles of a pair 416, a pose 416,
 * a point in the unit 112. */
#ifndef FLASHBVH_FLASHBVH_H
#define FLASHBVH_FLASHBVH_H

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/plain/byte_order.h"
#include "flashbvh/plain/core_costs.h"
#include "flashbvh/plain/core_cycles.h"
#include "flashbvh/plain/language.h"
#include "flashbvh/plain/points.h"
#include "flashbvh/plain/results.h"
#include "flashbvh/plain/status.h"
#include "flashbvh/version.hpp" /* macros only, for C and C++ */

#ifdef __cplusplus
extern "C" {
#endif

/* Meshes: image.hpp and mesh.hpp --------------------------------------------------------------- */

/** A baked mesh: a view of its image. 64 bytes on a 32-bit core, 88 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_mesh, 6, 40, uint64_t);

/** open_image(): `image` must start at a multiple of 4 bytes. `mesh` is written only on DONE.
 * IMAGE_KIND: the mesh is pre-indexed or has 32-bit indices. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_open(const void* image, size_t size,
                                                 flashbvh_mesh* mesh);

/** view_unchecked(), for an image that `flashbvh bake` has written into the firmware's C. */
void flashbvh_view_unchecked(const void* image, flashbvh_mesh* mesh);

/** Mesh::triangle_count. */
uint32_t flashbvh_mesh_triangles(const flashbvh_mesh* mesh);

/** Mesh::cell_bits: the cell's length in the unit, as the bits of an IEEE binary64. */
uint64_t flashbvh_mesh_cell(const flashbvh_mesh* mesh);

/** cells_per_unit(), for poses in the unit. */
float flashbvh_mesh_cells_per_unit(const flashbvh_mesh* mesh);

/** The unit of the lengths in a mesh's file. */
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

/** Mesh::unit; NONE if `bake` got no unit. */
flashbvh_unit flashbvh_mesh_unit(const flashbvh_mesh* mesh);

/** Mesh::origin. */
void flashbvh_mesh_origin(const flashbvh_mesh* mesh, int32_t origin[3]);

/** Mesh::is_closed. */
bool flashbvh_mesh_is_closed(const flashbvh_mesh* mesh);

/* Poses: pose.hpp and float.hpp ---------------------------------------------------------------- */

/** 1 in the fixed point of a rotation: 30 fraction bits. */
#define FLASHBVH_ROTATION_ONE (INT32_C(1) << 30)

/** A full turn as an angle. */
#define FLASHBVH_FULL_TURN (INT32_C(1) << 28)

/** Largest magnitude of a translation along each axis, in cells. */
#define FLASHBVH_MAX_TRANSLATION (INT32_C(1) << 29)

/** Pose: maps B's point p to rotation * p + translation in A's frame. 68 bytes. The pose stores an
 * error, which every query on it returns, so a maker's status may be ignored. */
typedef struct flashbvh_pose {
  union {
    unsigned char bytes[68];
    uint32_t word;
  } opaque;
} flashbvh_pose;

/** Pose::translated(), in cells. TRANSLATION_OUT_OF_RANGE. */
flashbvh_status flashbvh_pose_translated(int32_t x, int32_t y, int32_t z, flashbvh_pose* pose);

/** Pose::rigid(): `rotation` row by row; `fraction` in 1/65,536 cell, or null for zeros.
 * NOT_A_ROTATION; TRANSLATION_OUT_OF_RANGE. */
flashbvh_status flashbvh_pose_rigid(const int32_t rotation[9], const int32_t cells[3],
                                    const int16_t fraction[3], flashbvh_pose* pose);

/** pose_of(): `rotation` row by row, `translation` in the meshes' unit. Statuses as above. */
flashbvh_status flashbvh_pose_of_matrix(const float rotation[9], const float translation[3],
                                        float cells_per_unit, flashbvh_pose* pose);

/** pose_of(): `rotation` is w, x, y, z. */
flashbvh_status flashbvh_pose_of_quaternion(const float rotation[4], const float translation[3],
                                            float cells_per_unit, flashbvh_pose* pose);

/** Pose::composed(). `pose` may be either argument. */
flashbvh_status flashbvh_pose_composed(const flashbvh_pose* outer, const flashbvh_pose* inner,
                                       flashbvh_pose* pose);

/** Pose::inverse(). `inverse` may be `pose`. */
flashbvh_status flashbvh_pose_inverse(const flashbvh_pose* pose, flashbvh_pose* inverse);

/** Pose::relative(). `pose` may be either argument. */
flashbvh_status flashbvh_pose_relative(const flashbvh_pose* world_a, const flashbvh_pose* world_b,
                                       flashbvh_pose* pose);

/** Pose::status(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_pose_status(const flashbvh_pose* pose);

/** Returns the numbers of a pose whose status is DONE, as for flashbvh_pose_rigid(). Each array may
 * be null. */
void flashbvh_pose_values(const flashbvh_pose* pose, int32_t rotation[9], int32_t cells[3],
                          int16_t fraction[3]);

/* Queries: query.hpp --------------------------------------------------------------------------- */

/** PairQuery, with all its memory. 128 bytes on a 32-bit core, 152 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_query, 6, 104, uint32_t);

/** Starts a query between A and B, which is at `pose` in A's frame. SUSPENDED: there is work to
 * run; CELL_MISMATCH, or the pose's status, which every run returns again. */
flashbvh_status flashbvh_query_start(flashbvh_query* query, const flashbvh_mesh* a,
                                     const flashbvh_mesh* b, const flashbvh_pose* pose);

/** Query::status(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_query_status(const flashbvh_query* query);

/** Query::run(): does at most `work` (UINT32_MAX: no limit) and writes at most `capacity` pairs.
 * DONE; SUSPENDED: the work is spent; FULL: the array is; or the query's error. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_query_run(flashbvh_query* query, uint32_t work,
                                                          flashbvh_pair* pairs, uint32_t capacity);

/** Receives a pair of triangles that intersect; returns false to stop. `context`: the caller's. */
typedef bool flashbvh_visitor(flashbvh_pair pair, void* context);

/** Query::run(): passes each pair to `visit`. FULL: it returned false. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_query_visit(flashbvh_query* query, uint32_t work,
                                                            flashbvh_visitor* visit, void* context);

/** Query::stats(). */
flashbvh_stats flashbvh_query_stats(const flashbvh_query* query);

/** Query::last_pair(). Valid in a visitor, and after a run that wrote a pair and returned FULL. */
void flashbvh_query_last_pair(const flashbvh_query* query, flashbvh_triangle* a,
                              flashbvh_triangle* b);

/** Query::cursor(). Valid between runs. */
flashbvh_cursor flashbvh_query_cursor(const flashbvh_query* query);

/** Query::resume(), for a started query. SUSPENDED or DONE, as the other query; CURSOR_INVALID, and
 * nothing changes; or the query's own error. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_query_resume(flashbvh_query* query,
                                                         const flashbvh_cursor* cursor);

/* Contacts: contact.hpp ------------------------------------------------------------------------ */

/** contact_of(), for two triangles that intersect. */
void flashbvh_contact_of(const flashbvh_triangle* a, const flashbvh_triangle* b,
                         flashbvh_contact* contact);

/** contact_of_last(). Valid when flashbvh_query_last_pair() is. */
void flashbvh_query_last_contact(const flashbvh_query* query, flashbvh_contact* contact);

/** transform_pair(). Returns false, and writes nothing, if the pose has an error, the cells differ
 * or an id is not in its mesh. */
FLASHBVH_NODISCARD bool flashbvh_transform_pair(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                                const flashbvh_pose* pose, flashbvh_pair pair,
                                                flashbvh_triangle* of_a, flashbvh_triangle* of_b);

/** in_unit(): a point in the mesh's unit, to the nearest floats. */
void flashbvh_in_unit(const flashbvh_fine_point* point, const flashbvh_mesh* mesh, float at[3]);

/** millionths_of() for each coordinate; saturates at INT64_MAX and -INT64_MAX. */
void flashbvh_in_millionths(const flashbvh_fine_point* point, const flashbvh_mesh* mesh,
                            int64_t at[3]);

/* Time: time_bound.hpp; lib/docs/bounded_time.md has the proof --------------------------------- */

/** tree_size_of(), for an image that flashbvh_open() has opened. Else the error of the image. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_image_tree_size(const void* image, size_t size,
                                                            flashbvh_tree_size* tree);

/* Defines flashbvh_cortex_m0 to flashbvh_rv32imac. NOLINTBEGIN(readability-identifier-naming) */
#define FLASHBVH_CONSTANT(core, c_name, ...) extern const flashbvh_run_costs flashbvh_##c_name;
FLASHBVH_FOR_EACH_CORE(FLASHBVH_CONSTANT)
#undef FLASHBVH_CONSTANT
/* Defines flashbvh_cortex_m0_cycles to flashbvh_cortex_m4f_cycles. */
#define FLASHBVH_CONSTANT(core, c_name, ...) \
  extern const flashbvh_run_cycles flashbvh_##c_name##_cycles;
FLASHBVH_FOR_EACH_CORE_IN_CYCLES(FLASHBVH_CONSTANT)
#undef FLASHBVH_CONSTANT
/* NOLINTEND(readability-identifier-naming) */

/** work_within(): most work with which a run takes at most this many instructions; 0 if none. */
uint32_t flashbvh_work_within(uint64_t instructions, const flashbvh_run_costs* costs,
                              const flashbvh_tree_size* a, const flashbvh_tree_size* b);

/** most_instructions() of a run; not valid for UINT32_MAX, which is no limit. */
uint64_t flashbvh_most_instructions(const flashbvh_run_costs* costs, const flashbvh_tree_size* a,
                                    const flashbvh_tree_size* b, uint32_t work);

/** work_within(), in cycles, if a read of flash takes `wait_states`, at most 1000. */
uint32_t flashbvh_work_within_cycles(uint64_t cycles, const flashbvh_run_cycles* core,
                                     uint32_t wait_states, const flashbvh_tree_size* a,
                                     const flashbvh_tree_size* b);

/** most_cycles() of a run; arguments as for flashbvh_work_within_cycles(). */
uint64_t flashbvh_most_cycles(const flashbvh_run_cycles* core, uint32_t wait_states,
                              const flashbvh_tree_size* a, const flashbvh_tree_size* b,
                              uint32_t work);

/** most_work() of a whole query in one run. */
uint64_t flashbvh_most_work(const flashbvh_tree_size* a, const flashbvh_tree_size* b);

/** largest_step(): a run may overdraw by it, less 1. */
uint64_t flashbvh_largest_step(const flashbvh_tree_size* a, const flashbvh_tree_size* b);

/* One call for each query: collide.hpp ---------------------------------------------------------
 *
 * Each runs its own query on the stack to the end. It returns DONE, the query's error, or FULL
 * where stated. After an error `yes` is true, since an undecided pair may collide, and counts are
 * 0. */

/** intersects(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_intersects(const flashbvh_mesh* a,
                                                       const flashbvh_mesh* b,
                                                       const flashbvh_pose* pose, bool* yes);

/** Witness: two triangles as a hint for later queries. May be stored. */
typedef struct flashbvh_witness {
  uint16_t a;
  uint16_t b;
} flashbvh_witness;

/** The witness without a pair. */
#define FLASHBVH_NO_WITNESS \
  { UINT16_MAX, UINT16_MAX }

/** intersects() with a hint: the pair that intersected last; at first FLASHBVH_NO_WITNESS.
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

/** count_pairs(), in `count` of the result. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_count_pairs(const flashbvh_mesh* a,
                                                            const flashbvh_mesh* b,
                                                            const flashbvh_pose* pose);

/** find_pairs(). DONE: these are all; FULL: maybe not. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_find_pairs(const flashbvh_mesh* a,
                                                           const flashbvh_mesh* b,
                                                           const flashbvh_pose* pose,
                                                           flashbvh_pair* pairs, uint32_t capacity);

/** UnitContact: a pair of triangles that intersect, and their common part. */
typedef struct flashbvh_unit_contact {
  flashbvh_normal normal_a;
  flashbvh_normal normal_b;
  flashbvh_unit_point ends[2]; /**< of the common part, in A's frame and unit */
  flashbvh_pair triangles;
  bool yes; /**< false: no triangles intersect, and no other field is valid */
} flashbvh_unit_contact;

/** first_contact(). After an error `yes` is true and no other field is valid. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_first_contact(const flashbvh_mesh* a,
                                                          const flashbvh_mesh* b,
                                                          const flashbvh_pose* pose,
                                                          flashbvh_unit_contact* contact);

/** for_each_pair(). FULL: `visit` returned false. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_for_each_pair(const flashbvh_mesh* a,
                                                          const flashbvh_mesh* b,
                                                          const flashbvh_pose* pose,
                                                          flashbvh_visitor* visit, void* context);

#ifdef __cplusplus
}
#endif

#endif
