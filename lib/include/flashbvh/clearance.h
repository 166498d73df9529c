/* flashbvh for C: how far two meshes are apart, and what is within a distance. clearance.hpp says
 * what is asked, and what is not: surfaces, not solids.
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

/** The largest distance that can be asked about: 32,767 cells. */
#define FLASHBVH_MAX_DISTANCE ((uint32_t)32767 * 256)

/** One in the fixed point of a direction. */
#define FLASHBVH_UNIT_ONE ((int32_t)1 << 30)

/** Two triangles, as a later query begins with them. May be stored. */
typedef struct flashbvh_witness {
  uint16_t a;
  uint16_t b;
} flashbvh_witness;

/** What is known of a distance. */
typedef struct flashbvh_clearance {
  flashbvh_fine_point point_a; /**< where the nearest triangles are nearest, in A's frame */
  flashbvh_fine_point point_b;
  flashbvh_unit_vector direction; /**< from point_a to point_b; 0 if they intersect */
  uint32_t lower;                 /**< the distance is at least this; 0 while SUSPENDED */
  uint32_t upper; /**< at most this: in range that of these triangles, rounded up; UINT32_MAX if
                     none is known yet, or if it may be so much or more */
  flashbvh_pair triangles;  /**< by their ids */
  flashbvh_witness witness; /**< the same, as a seed for the next query */
  flashbvh_status status;   /**< DONE; SUSPENDED: not all was looked at; or an error */
  bool in_range; /**< false: B's lattice lies 48,000 cells or more along an axis from A's; `lower`
                    and `upper` hold, no triangles, no witness and no points are told */
} flashbvh_clearance;

/** Where a query about a distance stands between runs. */
typedef struct flashbvh_clearance_position {
  flashbvh_position walk;
  flashbvh_witness witness;
  bool has_witness;
} flashbvh_clearance_position;

/** A query about a distance and all its memory. 144 bytes on a 32-bit core, 176 on a 64-bit one. */
typedef struct flashbvh_clearance_query {
  union {
    unsigned char bytes[8 * sizeof(void*) + 112];
    uint32_t word;
    void* pointer;
  } opaque;
} flashbvh_clearance_query;

/**
 * Starts a query about the distance of A and B, which lies at `pose` in A's frame. `seed`: the
 * witness of an earlier pose, which spares most of the visits, or null. `tolerance`, in 2^-16: the
 * distance told may be larger than the true one by so much of that, and as much larger than
 * `lower`, but for what both are rounded by.
 *
 * SUSPENDED if there is something to run; DONE if the seed's triangles intersect; SEED_INVALID:
 * it is no pair of these meshes'; else as flashbvh_query_start().
 */
flashbvh_status flashbvh_clearance_start(flashbvh_clearance_query* query, const flashbvh_mesh* a,
                                         const flashbvh_mesh* b, const flashbvh_pose* pose,
                                         const flashbvh_witness* seed, uint16_t tolerance);

/** Does at most `*work`, and takes what it did from it, which UINT32_MAX stays: DONE, SUSPENDED or
 * the query's error. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_clearance_spend(flashbvh_clearance_query* query,
                                                            uint32_t* work);

/** What is known by now. */
void flashbvh_clearance_result(const flashbvh_clearance_query* query, flashbvh_clearance* result);

/** What the query did so far. */
flashbvh_counts flashbvh_clearance_counts(const flashbvh_clearance_query* query);

/** Between runs: for flashbvh_clearance_resume(). */
flashbvh_clearance_position flashbvh_clearance_position_of(const flashbvh_clearance_query* query);

/** As flashbvh_query_resume(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_clearance_resume(
    flashbvh_clearance_query* query, const flashbvh_clearance_position* position);

/** The distance in one call; as above. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_distance(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                                     const flashbvh_pose* pose,
                                                     const flashbvh_witness* seed,
                                                     flashbvh_clearance* result);

/** Whether any points of A and B are at most `distance` apart. After an error `yes` is true.
 * DISTANCE_OUT_OF_RANGE: beyond FLASHBVH_MAX_DISTANCE, or not to be told of meshes that lie 48,000
 * cells or more apart. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_closer_than(const flashbvh_mesh* a,
                                                        const flashbvh_mesh* b,
                                                        const flashbvh_pose* pose,
                                                        uint32_t distance, bool* yes);

/** A query for every pair of triangles within a distance, and all its memory. 136 bytes on a 32-bit
 * core, 160 on a 64-bit one. */
typedef struct flashbvh_within_query {
  union {
    unsigned char bytes[6 * sizeof(void*) + 112];
    uint32_t word;
    void* pointer;
  } opaque;
} flashbvh_within_query;

/** Starts a query for every pair of triangles within `distance`. DISTANCE_OUT_OF_RANGE: as of
 * flashbvh_closer_than(); else as flashbvh_query_start(), as are the meshes and the pose. */
flashbvh_status flashbvh_within_start(flashbvh_within_query* query, const flashbvh_mesh* a,
                                      const flashbvh_mesh* b, const flashbvh_pose* pose,
                                      uint32_t distance);

/** As flashbvh_query_status(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_within_status(const flashbvh_within_query* query);

/** As flashbvh_query_run(), in the same order; what a unit of work takes is not proven. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_within_run(flashbvh_within_query* query, uint32_t work,
                                                       flashbvh_pair* pairs, uint32_t capacity,
                                                       uint32_t* count);

/** As flashbvh_query_spend(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_within_spend(flashbvh_within_query* query,
                                                         uint32_t* work, flashbvh_pair* pairs,
                                                         uint32_t capacity, uint32_t* count);

/** As flashbvh_query_visit(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_within_visit(flashbvh_within_query* query,
                                                         uint32_t* work, flashbvh_visitor* visit,
                                                         void* context);

/** What the query did so far. */
flashbvh_counts flashbvh_within_counts(const flashbvh_within_query* query);

/** Between runs: for flashbvh_within_resume(). */
flashbvh_position flashbvh_within_position(const flashbvh_within_query* query);

/** As flashbvh_query_resume(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_within_resume(flashbvh_within_query* query,
                                                          const flashbvh_position* position);

/** The triangles of the pair reported last, in A's frame, in cells, where
 * flashbvh_query_last_pair() may be asked. */
void flashbvh_within_last_pair(const flashbvh_within_query* query, flashbvh_triangle* a,
                               flashbvh_triangle* b);

/** Where the pair reported last is nearest, where flashbvh_within_last_pair() may be asked. */
void flashbvh_within_last_nearest_points(const flashbvh_within_query* query,
                                         flashbvh_nearest_points* nearest);

/** Where two triangles are nearest, as flashbvh_within_last_pair() and flashbvh_transform_pair()
 * give them; differences of their corners are below 2^17 cells along each axis. */
void flashbvh_nearest_points_of(const flashbvh_triangle* a, const flashbvh_triangle* b,
                                flashbvh_nearest_points* nearest);

/** Hands each pair of triangles within a distance to `visit`, until it returns false: FULL. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_for_each_within(const flashbvh_mesh* a,
                                                            const flashbvh_mesh* b,
                                                            const flashbvh_pose* pose,
                                                            uint32_t distance,
                                                            flashbvh_visitor* visit, void* context);

/** A length in 1/256 cell, rounded down but for a rounding of 1/65,536 cell; UINT32_MAX, which
 * every query refuses, if it is negative, no number or too large. */
uint32_t flashbvh_fine_distance(float length, float cells_per_unit);

/** The length of so many 1/256 cells in the mesh's unit, to the nearest float. */
float flashbvh_length_in_unit(int64_t fine, const flashbvh_mesh* mesh);

#ifdef __cplusplus
}
#endif

#endif
