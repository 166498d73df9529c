/* flashbvh for C: pairs of triangles, contacts, distances, rays and motions of baked meshes, in
 * fixed memory. robot.h has robots.
 *
 * A C99 interface to what a firmware needs of the C++ library, with equal meshes, queries, statuses
 * and answers in equal order. Each comment names the C++ counterpart, whose header has the details.
 * No call allocates or keeps memory. So any number of queries may run at once, in interrupts too,
 * if no two calls write to one object.
 *
 * Unless stated otherwise, lengths are in cells: the unit of the lattice that all meshes of one
 * `flashbvh bake` share. Distances are in 1/256 cell; flashbvh_fine_length_rounded_up() and
 * flashbvh_length_in_unit() convert them.
 *
 * Pointers. The caller owns every object. The target of a pointer in an object must outlive the
 * object, at one address: an image its mesh, two meshes and a pose their query. Null pointers are
 * the caller's error and not checked, unless a comment allows them. An object must not be used
 * before the call that makes it. Objects may be copied by assignment, queries too: a copy runs on
 * its own. Shapes and deformable meshes point into themselves and must not be copied or moved.
 *
 * An error is never a permission: after it, `yes` is true and other results are not valid.
 * NOT_OPEN: a mesh was not opened; each call that takes meshes returns it.
 *
 * Stack on Cortex-M3 to M55 at -O2, in bytes (proofs/stack proves it): opening an image at most
 * 480, a run 592, pairs in one call 736, a contact 496, a pose 416; a distance's run 880, its
 * result 1,040, a distance in one call 1,216; a point inside 416, one body inside another 720; a
 * ray's hit 832, a segment of floats 352, a shape 352, a refit 256. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/plain/byte_order.h"
#include "flashbvh/plain/core_costs.h"
#include "flashbvh/plain/language.h"
#include "flashbvh/plain/motion_parts.h"
#include "flashbvh/plain/points.h"
#include "flashbvh/plain/results.h"
#include "flashbvh/plain/status.h"
#include "flashbvh/version.hpp" /* macros only, for C and C++ */

#ifdef __cplusplus
extern "C" {
#endif

/* Meshes: image.hpp and mesh.hpp --------------------------------------------------------------- */

/** A baked mesh: a view of its image. 72 bytes on a 32-bit core, 96 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_mesh, 7, 40, uint64_t);

/** open_image(): `image` must start at a multiple of 4 bytes. `mesh` is written only on DONE.
 * IMAGE_KIND: the mesh is pre-indexed or has 32-bit indices. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_open(const void* image, size_t size,
                                                 flashbvh_mesh* mesh);

/** view_unchecked(), for an image that `flashbvh bake` has written into the firmware's C. */
void flashbvh_view_unchecked(const void* image, flashbvh_mesh* mesh);

/** cells_per_unit(), for poses and lengths in the unit. */
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

/** Mesh::is_closed. */
bool flashbvh_mesh_is_closed(const flashbvh_mesh* mesh);

/* Poses: pose.hpp and float.hpp ---------------------------------------------------------------- */

/** 1 in the fixed point of a rotation or a direction: 30 fraction bits. */
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

/** Pose::rigid(): `rotation` row by row; `fraction` in 1/65,536 cell, or null for zeros.
 * NOT_A_ROTATION; TRANSLATION_OUT_OF_RANGE. */
flashbvh_status flashbvh_pose_rigid(const int32_t rotation[9], const int32_t cells[3],
                                    const int16_t fraction[3], flashbvh_pose* pose);

/** pose_of(): `rotation` row by row, `translation` in the meshes' unit. Statuses as above. */
flashbvh_status flashbvh_pose_of_matrix(const float rotation[9], const float translation[3],
                                        float cells_per_unit, flashbvh_pose* pose);

/** Pose::relative(): B's pose in A's frame, of both poses in the world. `pose` may be either
 * argument. */
flashbvh_status flashbvh_pose_relative(const flashbvh_pose* world_a, const flashbvh_pose* world_b,
                                       flashbvh_pose* pose);

/* Pairs of triangles: query.hpp, collide.hpp and contact.hpp ----------------------------------- */

/** PairQuery, with all its memory. 128 bytes on a 32-bit core, 152 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_query, 6, 104, uint32_t);

/** Starts a query between A and B, which is at `pose` in A's frame. SUSPENDED: there is work to
 * run; CELL_MISMATCH, or the pose's status, which every run returns again. */
flashbvh_status flashbvh_query_start(flashbvh_query* query, const flashbvh_mesh* a,
                                     const flashbvh_mesh* b, const flashbvh_pose* pose);

/** Query::run(): does at most `work` (UINT32_MAX: no limit) and writes at most `capacity` pairs.
 * DONE; SUSPENDED: the work is spent; FULL: the array is; or the query's error. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_query_run(flashbvh_query* query, uint32_t work,
                                                          flashbvh_pair* pairs, uint32_t capacity);

/** Query::cursor(). Valid between runs. */
flashbvh_cursor flashbvh_query_cursor(const flashbvh_query* query);

/** Query::resume(), for a started query. SUSPENDED or DONE, as the other query; CURSOR_INVALID, and
 * nothing changes; or the query's own error. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_query_resume(flashbvh_query* query,
                                                         const flashbvh_cursor* cursor);

/** contact_of_last(): of the last pair, valid after a run that wrote a pair and returned FULL. */
void flashbvh_query_last_contact(const flashbvh_query* query, flashbvh_contact* contact);

/** intersects(), in one call. After an error `yes` is true, since an undecided pair may collide. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_intersects(const flashbvh_mesh* a,
                                                       const flashbvh_mesh* b,
                                                       const flashbvh_pose* pose, bool* yes);

/** find_pairs(), in one call. DONE: these are all; FULL: maybe not. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_find_pairs(const flashbvh_mesh* a,
                                                           const flashbvh_mesh* b,
                                                           const flashbvh_pose* pose,
                                                           flashbvh_pair* pairs, uint32_t capacity);

/* Time: time_bound.hpp; lib/docs/bounded_time.md has the proof --------------------------------- */

/** tree_size_of(), for an image that flashbvh_open() has opened. Else the error of the image. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_image_tree_size(const void* image, size_t size,
                                                            flashbvh_tree_size* tree);

/* Defines flashbvh_cortex_m0 to flashbvh_rv32imac. NOLINTBEGIN(readability-identifier-naming) */
#define FLASHBVH_CONSTANT(core, c_name, ...) extern const flashbvh_run_costs flashbvh_##c_name;
FLASHBVH_FOR_EACH_CORE(FLASHBVH_CONSTANT)
#undef FLASHBVH_CONSTANT
/* NOLINTEND(readability-identifier-naming) */

/** work_within(): most work with which a run takes at most this many instructions; 0 if none. */
uint32_t flashbvh_work_within(uint64_t instructions, const flashbvh_run_costs* costs,
                              const flashbvh_tree_size* a, const flashbvh_tree_size* b);

/* Distances: clearance.hpp --------------------------------------------------------------------- */

/** The largest distance of a query: 2^20 cells. */
#define FLASHBVH_MAX_DISTANCE (UINT32_C(256) << 20)

/** Witness: two triangles as a hint for later queries. May be stored. */
typedef struct flashbvh_witness {
  uint16_t a;
  uint16_t b;
} flashbvh_witness;

/** The witness without a pair. */
#define FLASHBVH_NO_WITNESS \
  { UINT16_MAX, UINT16_MAX }

/** Clearance: the distance of two meshes' surfaces, as far as it is known. */
typedef struct flashbvh_clearance {
  flashbvh_fine_point point_a; /**< the nearest points of the triangles, in A's frame */
  flashbvh_fine_point point_b;
  flashbvh_unit_vector direction; /**< from point_a to point_b; 0 if they intersect */
  uint32_t lower;                 /**< lower bound of the distance; 0 while SUSPENDED */
  uint32_t upper;                 /**< upper bound; UINT32_MAX if none is known yet */
  flashbvh_pair triangles;        /**< by their ids */
  flashbvh_witness witness;       /**< these triangles as a hint for the next query */
  flashbvh_status status;         /**< DONE; SUSPENDED: work is left; or an error */
  bool in_range;                  /**< false: only `lower` and `upper` are valid */
} flashbvh_clearance;

/** ClearanceQuery, with all its memory. 144 bytes on a 32-bit core, 176 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_clearance_query, 8, 112, uint32_t);

/** Starts a query of the distance of A and B, which is at `pose` in A's frame. `hint`: a pair that
 * may be near; may be null. SUSPENDED: there is work to run; DONE: the hint's triangles intersect;
 * HINT_INVALID; else as flashbvh_query_start(). */
flashbvh_status flashbvh_clearance_start(flashbvh_clearance_query* query, const flashbvh_mesh* a,
                                         const flashbvh_mesh* b, const flashbvh_pose* pose,
                                         const flashbvh_witness* hint);

/** ClearanceQuery::run_within(): does at most `*work` and leaves the remainder in it; UINT32_MAX
 * does not change. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_clearance_run(flashbvh_clearance_query* query,
                                                          uint32_t* work);

/** ClearanceQuery::result(). */
void flashbvh_clearance_result(const flashbvh_clearance_query* query, flashbvh_clearance* result);

/** distance(), in one call; `hint` as for flashbvh_clearance_start(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_distance(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                                     const flashbvh_pose* pose,
                                                     const flashbvh_witness* hint,
                                                     flashbvh_clearance* result);

/** closer_than(), in one call. DISTANCE_OUT_OF_RANGE; after an error `yes` is true. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_closer_than(const flashbvh_mesh* a,
                                                        const flashbvh_mesh* b,
                                                        const flashbvh_pose* pose,
                                                        flashbvh_fine_length distance, bool* yes);

/** fine_length_rounded_up(): UINT32_MAX, which every query rejects, if the length is negative, not
 * a number or too large. */
flashbvh_fine_length flashbvh_fine_length_rounded_up(float length, float cells_per_unit);

/** length_in_unit(): a distance, or a coordinate of a point, in the mesh's unit, to the nearest
 * float. `fine`: in 1/256 cell, within +-2^39. */
float flashbvh_length_in_unit(int64_t fine, const flashbvh_mesh* mesh);

/* Solids: solid.hpp ---------------------------------------------------------------------------- */

/** The side of a closed surface on which a point lies. */
typedef enum flashbvh_point_side {
  FLASHBVH_POINT_OUTSIDE = 0,
  FLASHBVH_POINT_ON_SURFACE = 1,
  FLASHBVH_POINT_INSIDE = 2
} flashbvh_point_side;

/** inside(). NOT_CLOSED; after an error `side` is INSIDE. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_inside(const flashbvh_mesh* mesh,
                                                   const flashbvh_point* point,
                                                   flashbvh_point_side* side);

/** one_is_inside(), for bodies whose surfaces do not intersect: with it, the pairs' queries decide
 * about solids. NOT_CLOSED; after an error `yes` is true. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_one_is_inside(const flashbvh_mesh* a,
                                                          const flashbvh_mesh* b,
                                                          const flashbvh_pose* pose, bool* yes);

/* Rays: ray.hpp and float.hpp ------------------------------------------------------------------ */

/** Largest distance of a ray's ends from the mesh's origin along each axis, in cells. */
#define FLASHBVH_MAX_RAY_COORDINATE ((INT32_C(1) << 19) - 1)

/** The hint without a triangle. */
#define FLASHBVH_NO_HINT UINT16_C(0xFFFF)

/** RayHit: a ray's hit. */
typedef struct flashbvh_hit {
  int64_t above; /**< fraction of the segment's length: above / below, exact, from 0 to 1 */
  int64_t below;
  uint16_t triangle; /**< its id */
  uint16_t slot;     /**< slot in the mesh's array: a hint for the next ray */
  int8_t side;       /**< 1: the front is hit; -1: the back; 0: the plane's edge, or no area */
} flashbvh_hit;

/** nearest_hit(); `*yes`: there is one. `hint`: the slot of a triangle that may be near it, or
 * FLASHBVH_NO_HINT. RAY_OUT_OF_RANGE, HINT_INVALID: `*yes` is true and `*hit` is not valid. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_nearest_hit(const flashbvh_mesh* mesh,
                                                        const flashbvh_segment* segment,
                                                        uint16_t hint, bool* yes,
                                                        flashbvh_hit* hit);

/** distance_along(): the hit's distance from the ray's start, in 1/256 cell. */
uint32_t flashbvh_distance_along(const flashbvh_segment* segment, const flashbvh_hit* hit);

/** segment_of(), in the mesh's unit. RAY_OUT_OF_RANGE: `*segment` does not change. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_segment_of(const float origin[3],
                                                       const float direction[3], float reach,
                                                       float cells_per_unit,
                                                       flashbvh_segment* segment);

/* Shapes made at run time: shape.hpp -----------------------------------------------------------
 *
 * A shape's `mesh` is a mesh of one leaf, for every call that takes an opened mesh. A sphere is a
 * segment without length and a distance, a capsule is a segment and a distance:
 *     flashbvh_closer_than(&part, &capsule.mesh, &pose, radius, &yes)
 * To move a shape, use a pose, or make it again in place, which ends its queries. Coordinates are
 * in cells of the shape's own frame. `like`: its cell and unit are taken; it need not outlive the
 * shape. SHAPE_TOO_LARGE: queries of the shape then end with CELL_MISMATCH. */

/** A segment. 112 bytes on a 32-bit core, 136 on a 64-bit one. */
typedef struct flashbvh_segment_shape {
  flashbvh_mesh mesh; /**< for queries */
  unsigned char opaque[48];
} flashbvh_segment_shape;

/** A closed box. 232 bytes on a 32-bit core, 256 on a 64-bit one. */
typedef struct flashbvh_box_shape {
  flashbvh_mesh mesh; /**< for queries */
  unsigned char opaque[168];
} flashbvh_box_shape;

/** SegmentShape, from `p` to `q`. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_segment_shape_make(flashbvh_segment_shape* shape,
                                                               const flashbvh_mesh* like,
                                                               const flashbvh_point* p,
                                                               const flashbvh_point* q);

/** BoxShape: `lower` must not exceed `upper` along any axis. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_box_shape_make(flashbvh_box_shape* shape,
                                                           const flashbvh_mesh* like,
                                                           const flashbvh_point* lower,
                                                           const flashbvh_point* upper);

/* Deformable meshes: deformable.hpp and self.hpp -----------------------------------------------
 *
 * A deformable mesh is a baked mesh whose nodes and vertices were copied into the caller's memory.
 * Move any vertices, refit, and query: each call takes its `mesh`, on either side and at any pose.
 *
 *     static flashbvh_node nodes[cloth_NODE_COUNT];
 *     static flashbvh_vertex vertices[cloth_VERTEX_COUNT];
 *     flashbvh_deformable_make(&cloth, &baked, nodes, vertices);
 *     vertices[7].z -= 12;
 *     status = flashbvh_deformable_refit(&cloth, UINT32_MAX, &vertex);
 *
 * A query begun before a refit must not run after it, nor may its cursor be resumed. */

/** Node of a tree; internal. 16 bytes. */
typedef struct flashbvh_node {
  uint32_t opaque[4];
} flashbvh_node;

/** DeformableMesh. Must not move while queries use it. 104 bytes on a 32-bit core, 144 on a 64-bit
 * one. */
typedef struct flashbvh_deformable {
  flashbvh_mesh mesh; /**< for queries; CELL_MISMATCH while a refit is not done */
  union {
    unsigned char bytes[3 * sizeof(void*) + 28];
    uint32_t word;
    void* pointer;
  } opaque;
} flashbvh_deformable;

/** Copies all nodes and vertices of `baked`. These arrays, and the arrays or the image of `baked`,
 * must outlive the mesh. */
void flashbvh_deformable_make(flashbvh_deformable* deformable, const flashbvh_mesh* baked,
                              flashbvh_node* nodes, flashbvh_vertex* vertices);

/** DeformableMesh::refit(); `work`: number of nodes, UINT32_MAX: no limit. DONE; SUSPENDED: call
 * again. VERTEX_OUT_OF_LATTICE, which alone writes `vertex`: move that vertex back and refit. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_deformable_refit(flashbvh_deformable* deformable,
                                                             uint32_t work, uint32_t* vertex);

/** intersects_itself(), for any mesh. After an error `yes` is true. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_intersects_itself(const flashbvh_mesh* mesh, bool* yes);

/* Motions of a body: first_contact.hpp --------------------------------------------------------- */

/** The end of a motion. A time is a binary fraction of the motion; 0 is the start. */
#define FLASHBVH_MOTION_END (UINT32_C(1) << 30)

/** The largest `within` of a motion, in 1/256 cell. */
#define FLASHBVH_MAX_MOTION_DISTANCE (UINT32_C(32000) * 256)

/** BodyMotion: constant once made; any number of queries may share it. It stores an error, which
 * every query on it returns. 188 bytes on a 32-bit core, 192 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_body_motion, 1, 184, uint32_t);

/** BodyMotion::between(): straight, with the shorter turn. MOTION_OUT_OF_RANGE; the poses'
 * NOT_A_ROTATION and TRANSLATION_OUT_OF_RANGE. */
flashbvh_status flashbvh_body_motion_between(const flashbvh_pose* from, const flashbvh_pose* to,
                                             flashbvh_body_motion* motion);

/** FirstContact, with all its memory. 80 bytes on a 32-bit core, 96 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_first_contact_query, 3, 68, uint32_t);

/** Starts a query; meshes and motion must outlive it. `within`: bodies this near are in contact; 0:
 * only bodies that intersect. SUSPENDED: there is work to run. The motion's status;
 * MOTION_OUT_OF_RANGE, also for far origins; DISTANCE_OUT_OF_RANGE: `within` is beyond
 * FLASHBVH_MAX_MOTION_DISTANCE. Every run returns the status again, or CELL_MISMATCH. */
flashbvh_status flashbvh_first_contact_start(flashbvh_first_contact_query* query,
                                             const flashbvh_mesh* a, const flashbvh_mesh* b,
                                             const flashbvh_body_motion* motion,
                                             flashbvh_fine_length within);

/** FirstContact::run(): does at most `work`, overdrawn by one step; UINT32_MAX: no limit. The body
 * may move if the status is DONE and the outcome FREE. */
FLASHBVH_NODISCARD flashbvh_first_contact_answer
flashbvh_first_contact_run(flashbvh_first_contact_query* query, uint32_t work);

#ifdef __cplusplus
}
#endif
