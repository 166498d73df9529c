/* flashbvh for C: what a ray hits. ray.hpp says what a hit is and what a crossing, float.hpp
 * how flashbvh_segment_of() rounds.
 *
 * Stack on Cortex-M3 to M55 at -O2, in bytes (proofs/stack proves it): a hit 832, crossings
 * 528, a segment of floats 352.
 */
#ifndef FLASHBVH_RAY_H
#define FLASHBVH_RAY_H

#include "flashbvh/flashbvh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Largest distance of a ray's ends from the mesh's origin along each axis, in cells. */
#define FLASHBVH_MAX_RAY_COORDINATE (((int32_t)1 << 19) - 1)

/** No triangle to begin with. */
#define FLASHBVH_NO_HINT ((uint16_t)0xFFFF)

/** RayHit: what a ray hits. */
typedef struct flashbvh_hit {
  int64_t above; /**< how far along: above / below of the segment, exactly, from 0 to 1 */
  int64_t below;
  uint16_t triangle; /**< its id */
  uint16_t slot;     /**< in the mesh's array: a hint for the next ray */
  int8_t side;       /**< 1: the front is hit; -1: the back; 0: the edge of a plane */
} flashbvh_hit;

/** nearest_hit(); `*yes`: there is one. `hint`: the slot of a triangle that may be near it, or
 * FLASHBVH_NO_HINT. RAY_OUT_OF_RANGE, HINT_INVALID: then `*yes` is true and `*hit` is nothing. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_nearest_hit(const flashbvh_mesh* mesh,
                                                        const flashbvh_segment* segment,
                                                        uint16_t hint, bool* yes,
                                                        flashbvh_hit* hit);

/** any_hit(); as above. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_any_hit(const flashbvh_mesh* mesh,
                                                    const flashbvh_segment* segment, bool* yes,
                                                    flashbvh_hit* hit);

/** Takes a hit; false for no more. */
typedef bool flashbvh_hit_visitor(const flashbvh_hit* hit, void* context);

/** for_each_hit(), in the tree's order, until `visit` returns false: FULL. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_for_each_hit(const flashbvh_mesh* mesh,
                                                         const flashbvh_segment* segment,
                                                         flashbvh_hit_visitor* visit,
                                                         void* context);

/** signed_crossings(). NOT_CLOSED, RAY_OUT_OF_RANGE: 0. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_signed_crossings(const flashbvh_mesh* mesh,
                                                             const flashbvh_segment* segment,
                                                             int32_t* outwards);

/** point_along(): where a hit is. */
void flashbvh_point_along(const flashbvh_segment* segment, const flashbvh_hit* hit,
                          flashbvh_fine_point* point);

/** distance_along(): how far that is from the ray's start, in 1/256 cell. */
uint32_t flashbvh_distance_along(const flashbvh_segment* segment, const flashbvh_hit* hit);

/** segment_of(), in the mesh's unit. RAY_OUT_OF_RANGE: then `*segment` is as it was. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_segment_of(const float origin[3],
                                                       const float direction[3], float reach,
                                                       float cells_per_unit,
                                                       flashbvh_segment* segment);

#ifdef __cplusplus
}
#endif

#endif
