/* flashbvh for C: how far two meshes are apart, and what is within a distance. clearance.hpp says
 * what a distance is: between surfaces, not solids.
 *
 * Distances are in 1/256 cell; flashbvh_fine_distance() and flashbvh_length_in_unit() turn them
 * from and into lengths.
 *
 * Stack on Cortex-M3 to M55 at -O2, in bytes (proofs/stack proves it): a run 880, a result
 * 1,040, nearest points 928, a question in one call 1,216.
 */
#ifndef FLASHBVH_CLEARANCE_H
#define FLASHBVH_CLEARANCE_H

#include "flashbvh/flashbvh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The largest distance of a query: 2^20 cells. */
#define FLASHBVH_MAX_DISTANCE ((uint32_t)256 << 20)

/** One in the fixed point of a direction. */
#define FLASHBVH_UNIT_ONE ((int32_t)1 << 30)

/** Clearance: what is known of a distance. */
typedef struct flashbvh_clearance {
  flashbvh_fine_point point_a; /**< where the nearest triangles are nearest, in A's frame */
  flashbvh_fine_point point_b;
  flashbvh_unit_vector direction; /**< from point_a to point_b; 0 if they intersect */
  uint32_t lower;                 /**< the distance is at least this; 0 while SUSPENDED */
  uint32_t upper;                 /**< at most this; UINT32_MAX if none is known yet */
  flashbvh_pair triangles;        /**< by their ids */
  flashbvh_witness witness;       /**< the same, as a hint for the next query */
  flashbvh_status status;         /**< DONE; SUSPENDED: not all was looked at; or an error */
  bool in_range;                  /**< false: `lower` and `upper` hold, nothing else */
} flashbvh_clearance;

/** ClearanceQuery, and all its memory. 144 bytes on a 32-bit core, 176 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_clearance_query, 8, 112, uint32_t);

/** ClearanceOptions: what a query may begin with. */
typedef struct flashbvh_clearance_options {
  const flashbvh_witness* hint; /**< a pair that may be near; may be null */
  uint16_t tolerance;           /**< in 2^-16 of the distance */
} flashbvh_clearance_options;

/** Starts a query of the distance of A and B, which lies at `pose` in A's frame. `options` may be
 * null: no hint, no tolerance. SUSPENDED if there is something to run; DONE if the hint's triangles
 * intersect; HINT_INVALID; else as flashbvh_query_start(). */
flashbvh_status flashbvh_clearance_start(flashbvh_clearance_query* query, const flashbvh_mesh* a,
                                         const flashbvh_mesh* b, const flashbvh_pose* pose,
                                         const flashbvh_clearance_options* options);

/** ClearanceQuery::run_within(): does at most `*work`, and leaves there what is left of it;
 * UINT32_MAX stays. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_clearance_run(flashbvh_clearance_query* query,
                                                          uint32_t* work);

/** ClearanceQuery::result(). */
void flashbvh_clearance_result(const flashbvh_clearance_query* query, flashbvh_clearance* result);

/** ClearanceQuery::stats(). */
flashbvh_stats flashbvh_clearance_stats(const flashbvh_clearance_query* query);

/** ClearanceQuery::cursor(), between runs. */
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
                                                        uint32_t distance, bool* yes);

/** WithinQuery, and all its memory. 136 bytes on a 32-bit core, 160 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_within_query, 6, 112, uint32_t);

/** Starts a query for each pair of triangles within `distance`. DISTANCE_OUT_OF_RANGE; else as
 * flashbvh_query_start(). */
flashbvh_status flashbvh_within_start(flashbvh_within_query* query, const flashbvh_mesh* a,
                                      const flashbvh_mesh* b, const flashbvh_pose* pose,
                                      uint32_t distance);

/** As flashbvh_query_status(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_within_status(const flashbvh_within_query* query);

/** As flashbvh_query_run(), in the same order; what a unit of work takes is not proven. */
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

/** nearest_points_of() of the last pair, where flashbvh_within_last_pair() may be called. */
void flashbvh_within_last_nearest_points(const flashbvh_within_query* query,
                                         flashbvh_nearest_points* nearest);

/** nearest_points_of(): corners differ by less than 2^17 cells along each axis. */
void flashbvh_nearest_points_of(const flashbvh_triangle* a, const flashbvh_triangle* b,
                                flashbvh_nearest_points* nearest);

/** Hands each pair of triangles within a distance to `visit`, until it returns false: FULL. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_for_each_within(const flashbvh_mesh* a,
                                                            const flashbvh_mesh* b,
                                                            const flashbvh_pose* pose,
                                                            uint32_t distance,
                                                            flashbvh_visitor* visit, void* context);

/** fine_distance(): in 1/256 cell; UINT32_MAX, which every query refuses, if the length is
 * negative, no number or too large. */
uint32_t flashbvh_fine_distance(float length, float cells_per_unit);

/** length_in_unit(): of 1/256 cells in the mesh's unit, to the nearest float. */
float flashbvh_length_in_unit(int64_t fine, const flashbvh_mesh* mesh);

#ifdef __cplusplus
}
#endif

#endif
