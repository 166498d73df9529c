/* flashbvh for C: which triangles of one baked mesh intersect which triangles of another.
 *
 * A C99 face of the C++ library flashbvh.hpp: the same meshes, queries, statuses and answers, in
 * the same order. C++ alone has meshes of 32-bit indices and the paper's traversals. It allocates
 * nothing, keeps nothing of its own, and may be called for any number of queries at once, in
 * interrupts too, as long as no two calls write the same object.
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

#include "flashbvh/detail/arch/byte_order.h"
#include "flashbvh/plain/counts.h"
#include "flashbvh/plain/points.h"
#include "flashbvh/status.h"
#include "flashbvh/version.hpp" /* macros alone: C as well as C++ */

#if defined(__GNUC__)
#define FLASHBVH_NODISCARD __attribute__((warn_unused_result))
#else
#define FLASHBVH_NODISCARD
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Meshes --------------------------------------------------------------------------------------- */

/** A baked mesh, opened: a view of its image. 64 bytes on a 32-bit core, 88 on a 64-bit one. */
typedef struct flashbvh_mesh {
  union {
    unsigned char bytes[6 * sizeof(void*) + 40];
    uint64_t word;
    void* pointer;
  } opaque;
} flashbvh_mesh;

/**
 * Opens the image that `flashbvh bake --format image` wrote, in place, in flash. `image` starts at
 * a multiple of 4 bytes and has at least `size`.
 *
 * Checks all of it, in time proportional to `size`; the checksum alone takes about 50 instructions
 * a byte. `mesh` is written only on DONE; every query on it then stays inside the image and ends.
 * Else one of FLASHBVH_STATUS_IMAGE_...; images of pre-indexed meshes and of 32-bit indices give
 * IMAGE_KIND.
 */
FLASHBVH_NODISCARD flashbvh_status flashbvh_open(const void* image, size_t size,
                                                 flashbvh_mesh* mesh);

/** Triangles of the mesh that the image has. */
uint32_t flashbvh_mesh_triangles(const flashbvh_mesh* mesh);

/** The cell in the mesh's unit, as the bits of an IEEE binary64: copy them into a `double`. */
uint64_t flashbvh_mesh_cell(const flashbvh_mesh* mesh);

/** The number of cells in a unit, to the nearest float: for poses in the unit. */
float flashbvh_mesh_cells_per_unit(const flashbvh_mesh* mesh);

/** Of lengths: what the numbers of a mesh's file mean, where `bake` was told. */
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

/** The unit of the mesh's file; NONE if `bake` wasn't told. */
flashbvh_unit flashbvh_mesh_unit(const flashbvh_mesh* mesh);

/** The point of the mesh's frame, as it was drawn, around which its lattice lies. */
void flashbvh_mesh_origin(const flashbvh_mesh* mesh, int32_t origin[3]);

/** Whether each edge is run through as often one way as the other: a surface without holes whose
 * triangles face alike. */
bool flashbvh_mesh_is_closed(const flashbvh_mesh* mesh);

/* Poses ---------------------------------------------------------------------------------------- */

/** One in the fixed point of a rotation: 30 fraction bits. */
#define FLASHBVH_ROTATION_ONE ((int32_t)1 << 30)

/** Largest magnitude of a translation, in cells. */
#define FLASHBVH_MAX_TRANSLATION ((int32_t)1 << 29)

/** B's point p lies at rotation * p + translation in A's frame. 68 bytes.
 *
 * Checked when it is made. A pose that can't be is kept as an error, which every query on it
 * returns, and every pose made of it; so the statuses of the makers may be left unread. */
typedef struct flashbvh_pose {
  union {
    unsigned char bytes[68];
    uint32_t word;
  } opaque;
} flashbvh_pose;

/** B translated by x, y, z cells, not rotated. TRANSLATION_OUT_OF_RANGE beyond
 * +-FLASHBVH_MAX_TRANSLATION. */
flashbvh_status flashbvh_pose_translated(int32_t x, int32_t y, int32_t z, flashbvh_pose* pose);

/**
 * B rotated and translated. `rotation`: row by row, FLASHBVH_ROTATION_ONE is 1; kept to 2^-22.
 * `cells`: the translation, rounded to whole cells. `fraction`: what rounding left, in 1/65,536 of
 * a cell, or null for nothing.
 *
 * NOT_A_ROTATION if an entry of R^T R is further than 2^-13 from the identity's, or the matrix
 * mirrors; within that it is used as it is, not mended. TRANSLATION_OUT_OF_RANGE as above.
 */
flashbvh_status flashbvh_pose_rigid(const int32_t rotation[9], const int32_t cells[3],
                                    const int16_t fraction[3], flashbvh_pose* pose);

/**
 * The same from floats, `rotation` row by row, `translation` in the meshes' unit: as exactly as
 * FLASHBVH_ROTATION_ONE and 1/65,536 of a cell have them, and alike on every core, with no
 * arithmetic in floats. What is no number or out of range gives the same statuses.
 */
flashbvh_status flashbvh_pose_of_matrix(const float rotation[9], const float translation[3],
                                        float cells_per_unit, flashbvh_pose* pose);

/** The same of a quaternion: `rotation` is w, x, y, z, of a squared length within 2^-10 of 1, and
 * taken as one of length 1. */
flashbvh_status flashbvh_pose_of_quaternion(const float rotation[4], const float translation[3],
                                            float cells_per_unit, flashbvh_pose* pose);

/** First `inner`, then `outer`: B in A's frame from B in C's and C in A's. `pose` may be one of
 * them. The rotation is rounded to 2^-22, the translation to 2^-16 cells; tolerances add up. */
flashbvh_status flashbvh_pose_composed(const flashbvh_pose* outer, const flashbvh_pose* inner,
                                       flashbvh_pose* pose);

/** A in B's frame from B in A's. `inverse` may be `pose`. */
flashbvh_status flashbvh_pose_inverse(const flashbvh_pose* pose, flashbvh_pose* inverse);

/** B in A's frame from both in the world's. `pose` may be one of them. */
flashbvh_status flashbvh_pose_relative(const flashbvh_pose* world_a, const flashbvh_pose* world_b,
                                       flashbvh_pose* pose);

/** DONE if queries can use the pose, else why not. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_pose_status(const flashbvh_pose* pose);

/** The numbers of a pose whose status is DONE, as flashbvh_pose_rigid() takes them. Each of the
 * arrays may be null. */
void flashbvh_pose_values(const flashbvh_pose* pose, int32_t rotation[9], int32_t cells[3],
                          int16_t fraction[3]);

/* Queries -------------------------------------------------------------------------------------- */

/** Where a query stands between runs. 12 bytes, which may be stored for any time. */
typedef struct flashbvh_position {
  uint16_t a;
  uint16_t b;
  uint32_t untested;
  uint8_t state;
  uint8_t reserved[3]; /**< written as 0, not read */
} flashbvh_position;

/** A query and all its memory. 128 bytes on a 32-bit core, 152 on a 64-bit one. */
typedef struct flashbvh_query {
  union {
    unsigned char bytes[6 * sizeof(void*) + 104];
    uint32_t word;
    void* pointer;
  } opaque;
} flashbvh_query;

/**
 * Starts a query between A and B, which lies at `pose` in A's frame. All three outlive it. No visit
 * is made: under a rotation this costs what telling two separated objects apart does.
 *
 * SUSPENDED if there is something to run. CELL_MISMATCH, or the pose's status, which every run
 * returns again.
 */
flashbvh_status flashbvh_query_start(flashbvh_query* query, const flashbvh_mesh* a,
                                     const flashbvh_mesh* b, const flashbvh_pose* pose);

/** What the last run returned, but SUSPENDED for FULL: there may be something left to do. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_query_status(const flashbvh_query* query);

/**
 * Does at most `work` and writes at most `capacity` pairs to `pairs`, their number to `count`: 0
 * after an error. A query gives the same pairs in the same order, however it is cut into runs.
 *
 * Work: a visit to a pair of boxes is 1, a leaf taken as a shape 8, two triangles tested 32; see
 * bound.hpp for the time that it takes. With work of 1 or more a run always gets on: the step that
 * it can't quite pay for is done, and is the last. UINT32_MAX: all there is to do.
 *
 * DONE: there are no more. SUSPENDED: the work is done. FULL: `pairs` is. After these two the next
 * run goes on where this one ended.
 */
FLASHBVH_NODISCARD flashbvh_status flashbvh_query_run(flashbvh_query* query, uint32_t work,
                                                      flashbvh_pair* pairs, uint32_t capacity,
                                                      uint32_t* count);

/** The same, and takes what it did from `*work`, which UINT32_MAX stays. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_query_spend(flashbvh_query* query, uint32_t* work,
                                                        flashbvh_pair* pairs, uint32_t capacity,
                                                        uint32_t* count);

/** Takes a pair of triangles that intersect; false for no more. `context` is the caller's. */
typedef bool flashbvh_visitor(flashbvh_pair pair, void* context);

/** The same, handing each pair to `visit`, until it returns false: FULL. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_query_visit(flashbvh_query* query, uint32_t* work,
                                                        flashbvh_visitor* visit, void* context);

/** What the query did so far. */
flashbvh_counts flashbvh_query_counts(const flashbvh_query* query);

/** After a run that wrote a pair and returned FULL, and inside a visitor: the triangles of the last
 * pair, transformed. */
void flashbvh_query_last_pair(const flashbvh_query* query, flashbvh_triangle* a,
                              flashbvh_triangle* b);

/** Where the query stands, between runs: for flashbvh_query_resume(). */
flashbvh_position flashbvh_query_position(const flashbvh_query* query);

/**
 * Takes a started query to the position of another one on the same meshes and pose; counts go on
 * from what they are. SUSPENDED or DONE, as the other query was. POSITION_INVALID, and nothing
 * changes, if no query on these meshes has such a position. That it is one of another pose, or of
 * other meshes, is not told where it could be one of this query.
 * The query's own error, if it has one.
 */
FLASHBVH_NODISCARD flashbvh_status flashbvh_query_resume(flashbvh_query* query,
                                                         const flashbvh_position* position);

/* Contacts ------------------------------------------------------------------------------------- */

/**
 * Where two triangles intersect, as flashbvh_query_last_pair() and flashbvh_transform_pair() have
 * them. 1,800 instructions on a Cortex-M4 for two planes that cross, at most 8,500; 496 bytes of
 * stack on Cortex-M3 to M55.
 */
void flashbvh_contact_of(const flashbvh_triangle* a, const flashbvh_triangle* b,
                         flashbvh_contact* contact);

/** The same of the last pair, where flashbvh_query_last_pair() may be asked. */
void flashbvh_query_last_contact(const flashbvh_query* query, flashbvh_contact* contact);

/** The triangles of a reported pair at any later time. False, and nothing is written, if the pose
 * is in error, the cells differ or an id isn't in its mesh. Looks through the ids of both meshes
 * one by one. */
FLASHBVH_NODISCARD bool flashbvh_transform_pair(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                                const flashbvh_pose* pose, flashbvh_pair pair,
                                                flashbvh_triangle* of_a, flashbvh_triangle* of_b);

/** A point in the mesh's unit: each coordinate rounded once, to the nearest float. A float has 24
 * bits, which a point 65,536 cells off takes up. */
void flashbvh_in_unit(const flashbvh_fine_point* point, const flashbvh_mesh* mesh, float at[3]);

/** The same in millionths of the unit, to the nearest: of millimetres, nanometres. INT64_MAX or its
 * negative where that is too small. */
void flashbvh_in_millionths(const flashbvh_fine_point* point, const flashbvh_mesh* mesh,
                            int64_t at[3]);

/* Time -----------------------------------------------------------------------------------------
 *
 * What queries can cost at worst: lib/docs/bounded_time.md has the proof. */

/** Of an image that flashbvh_open() has opened. Else the status with which it is no image. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_image_tree_size(const void* image, size_t size,
                                                            flashbvh_tree_size* tree);

/* Names as all others of C. NOLINTBEGIN(readability-identifier-naming) */
extern const flashbvh_run_costs flashbvh_cortex_m0;
extern const flashbvh_run_costs flashbvh_cortex_m3;
extern const flashbvh_run_costs flashbvh_cortex_m4f;
extern const flashbvh_run_costs flashbvh_cortex_m7;
extern const flashbvh_run_costs flashbvh_cortex_m33;
extern const flashbvh_run_costs flashbvh_cortex_m55;
extern const flashbvh_run_costs flashbvh_rv32imac;
/* NOLINTEND(readability-identifier-naming) */

/** The most work for which a run stays within so many instructions; 0 if none does. */
uint32_t flashbvh_work_within(uint64_t instructions, const flashbvh_run_costs* costs,
                              const flashbvh_tree_size* a, const flashbvh_tree_size* b);

/** The most instructions of a run of so much work, whatever the pose, and where the query stands.
 * Not of UINT32_MAX, which is no limit. */
uint64_t flashbvh_most_instructions(const flashbvh_run_costs* costs, const flashbvh_tree_size* a,
                                    const flashbvh_tree_size* b, uint32_t work);

/** The most work of a whole query in one run, at any pose. */
uint64_t flashbvh_most_work(const flashbvh_tree_size* a, const flashbvh_tree_size* b);

/** The most work of one step: a run may overdraw by it, less 1. */
uint64_t flashbvh_largest_step(const flashbvh_tree_size* a, const flashbvh_tree_size* b);

/* One question, one call ------------------------------------------------------------------------
 *
 * Each runs a query of its own, on the stack, to its end and returns DONE or the query's error,
 * FULL where said. */

/** Whether any two triangles intersect; ends at the first pair that does. After an error `yes` is
 * true: what can't be told may collide. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_intersects(const flashbvh_mesh* a,
                                                       const flashbvh_mesh* b,
                                                       const flashbvh_pose* pose, bool* yes);

/** The same, and that pair in `found`, which is written only if there is one. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_first_pair(const flashbvh_mesh* a,
                                                       const flashbvh_mesh* b,
                                                       const flashbvh_pose* pose, bool* yes,
                                                       flashbvh_pair* found);

/** How many pairs of triangles intersect; 0 after an error. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_count_pairs(const flashbvh_mesh* a,
                                                        const flashbvh_mesh* b,
                                                        const flashbvh_pose* pose, uint32_t* pairs);

/** The first `capacity` pairs that intersect, their number in `count`. DONE: these are all; FULL:
 * there may be more. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_find_pairs(const flashbvh_mesh* a,
                                                       const flashbvh_mesh* b,
                                                       const flashbvh_pose* pose,
                                                       flashbvh_pair* pairs, uint32_t capacity,
                                                       uint32_t* count);

/** Hands each intersecting pair to `visit`, in the query's order, until it returns false: FULL. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_for_each_pair(const flashbvh_mesh* a,
                                                          const flashbvh_mesh* b,
                                                          const flashbvh_pose* pose,
                                                          flashbvh_visitor* visit, void* context);

#ifdef __cplusplus
}
#endif

#endif
