/* flashbvh for C: the distance of two meshes, and their pairs of triangles within a distance.
 * clearance.hpp defines the distance: between surfaces, not solids.
 *
 * Distances are in 1/256 cell; flashbvh_fine_length_rounded_up() and
 * flashbvh_length_in_unit() convert lengths.
 *
 * Stack on Cortex-M3 to M55 at -O2, in bytes (proofs/stack proves it): a run 880, a result 1,040,
 * nearest points 928, a query in one call 1,216. */
#ifndef FLASHBVH_CLEARANCE_H
#define FLASHBVH_CLEARANCE_H

#include "flashbvh/flashbvh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The largest distance of a query: 2^20 cells. */
#define FLASHBVH_MAX_DISTANCE (UINT32_C(256) << 20)

/** 1 in the fixed point of a direction. */
#define FLASHBVH_UNIT_ONE (INT32_C(1) << 30)

/** Clearance: the distance of two meshes, as far as it is known. */
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

/** ClearanceOptions: optional arguments of a distance query. */
typedef struct flashbvh_clearance_options {
  const flashbvh_witness* hint; /**< a pair that may be near; may be null */
  uint16_t tolerance;           /**< relative tolerance, in 2^-16 */
} flashbvh_clearance_options;

/** Starts a query of the distance of A and B, which is at `pose` in A's frame. `options` may be
 * null: no hint, no tolerance. SUSPENDED: there is work to run; DONE: the hint's triangles
 * intersect; HINT_INVALID; else as flashbvh_query_start(). */
flashbvh_status flashbvh_clearance_start(flashbvh_clearance_query* query, const flashbvh_mesh* a,
                                         const flashbvh_mesh* b, const flashbvh_pose* pose,
                                         const flashbvh_clearance_options* options);

/** ClearanceQuery::run_within(): does at most `*work` and leaves the remainder in it; UINT32_MAX
 * does not change. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_clearance_run(flashbvh_clearance_query* query,
                                                          uint32_t* work);

/** ClearanceQuery::result(). */
void flashbvh_clearance_result(const flashbvh_clearance_query* query, flashbvh_clearance* result);

/** ClearanceQuery::stats(). */
flashbvh_stats flashbvh_clearance_stats(const flashbvh_clearance_query* query);

/** ClearanceQuery::cursor(). Valid between runs. */
flashbvh_cursor flashbvh_clearance_cursor(const flashbvh_clearance_query* query);

/** ClearanceQuery::resume(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_clearance_resume(flashbvh_clearance_query* query,
                                                             const flashbvh_cursor* cursor);

/** distance(); `hint` may be null. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_distance(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                                     const flashbvh_pose* pose,
                                                     const flashbvh_witness* hint,
                                                     flashbvh_clearance* result);

/** closer_than(). DISTANCE_OUT_OF_RANGE; after an error `yes` is true. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_closer_than(const flashbvh_mesh* a,
                                                        const flashbvh_mesh* b,
                                                        const flashbvh_pose* pose,
                                                        flashbvh_fine_length distance, bool* yes);

/** WithinQuery, with all its memory. 136 bytes on a 32-bit core, 160 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_within_query, 6, 112, uint32_t);

/** Starts a query for all pairs of triangles within `distance`. DISTANCE_OUT_OF_RANGE; else as
 * flashbvh_query_start(). */
flashbvh_status flashbvh_within_start(flashbvh_within_query* query, const flashbvh_mesh* a,
                                      const flashbvh_mesh* b, const flashbvh_pose* pose,
                                      flashbvh_fine_length distance);

/** As flashbvh_query_status(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_within_status(const flashbvh_within_query* query);

/** As flashbvh_query_run(), in equal order; the time of a unit of work is not proven. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_within_run(flashbvh_within_query* query,
                                                           uint32_t work, flashbvh_pair* pairs,
                                                           uint32_t capacity);

/** As flashbvh_query_visit(). */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_within_visit(flashbvh_within_query* query,
                                                             uint32_t work, flashbvh_visitor* visit,
                                                             void* context);

/** As flashbvh_query_stats(). */
flashbvh_stats flashbvh_within_stats(const flashbvh_within_query* query);

/** As flashbvh_query_cursor(). */
flashbvh_cursor flashbvh_within_cursor(const flashbvh_within_query* query);

/** As flashbvh_query_resume(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_within_resume(flashbvh_within_query* query,
                                                          const flashbvh_cursor* cursor);

/** As flashbvh_query_last_pair(). */
void flashbvh_within_last_pair(const flashbvh_within_query* query, flashbvh_triangle* a,
                               flashbvh_triangle* b);

/** nearest_points_of() the last pair. Valid when flashbvh_within_last_pair() is. */
void flashbvh_within_last_nearest_points(const flashbvh_within_query* query,
                                         flashbvh_nearest_points* nearest);

/** nearest_points_of(): corners must differ by less than 2^17 cells along each axis. */
void flashbvh_nearest_points_of(const flashbvh_triangle* a, const flashbvh_triangle* b,
                                flashbvh_nearest_points* nearest);

/** Passes each pair of triangles within a distance to `visit`. FULL: it returned false. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_for_each_within(const flashbvh_mesh* a,
                                                            const flashbvh_mesh* b,
                                                            const flashbvh_pose* pose,
                                                            flashbvh_fine_length distance,
                                                            flashbvh_visitor* visit, void* context);

/** fine_length_rounded_up(): UINT32_MAX, which every query rejects, if the length is negative, not
 * a number or too large. */
flashbvh_fine_length flashbvh_fine_length_rounded_up(float length, float cells_per_unit);

/** length_in_unit(): a length in the mesh's unit, to the nearest float. `fine`: in 1/256 cell,
 * within +-2^39. */
float flashbvh_length_in_unit(int64_t fine, const flashbvh_mesh* mesh);

#ifdef __cplusplus
}
#endif

#endif
