/* flashbvh for C: the triangles that a ray hits. ray.hpp defines hits and crossings; float.hpp has
 * the rounding of flashbvh_segment_of().
 *
 * Stack on Cortex-M3 to M55 at -O2, in bytes (proofs/stack proves it): a hit 832, crossings 528, a
 * segment from floats 352. */
#ifndef FLASHBVH_RAY_H
#define FLASHBVH_RAY_H

#include "flashbvh/flashbvh.h"

#ifdef __cplusplus
extern "C" {
#endif

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

/** any_hit(). Statuses as above. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_any_hit(const flashbvh_mesh* mesh,
                                                    const flashbvh_segment* segment, bool* yes,
                                                    flashbvh_hit* hit);

/** Receives a hit; returns false to stop. */
typedef bool flashbvh_hit_visitor(const flashbvh_hit* hit, void* context);

/** for_each_hit(), in the tree's order. FULL: `visit` returned false. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_for_each_hit(const flashbvh_mesh* mesh,
                                                         const flashbvh_segment* segment,
                                                         flashbvh_hit_visitor* visit,
                                                         void* context);

/** signed_crossings(). NOT_CLOSED, RAY_OUT_OF_RANGE: `*outwards` is 0. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_signed_crossings(const flashbvh_mesh* mesh,
                                                             const flashbvh_segment* segment,
                                                             int32_t* outwards);

/** point_along(): a hit's point. */
void flashbvh_point_along(const flashbvh_segment* segment, const flashbvh_hit* hit,
                          flashbvh_fine_point* point);

/** distance_along(): the hit's distance from the ray's start, in 1/256 cell. */
uint32_t flashbvh_distance_along(const flashbvh_segment* segment, const flashbvh_hit* hit);

/** segment_of(), in the mesh's unit. RAY_OUT_OF_RANGE: `*segment` does not change. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_segment_of(const float origin[3],
                                                       const float direction[3], float reach,
                                                       float cells_per_unit,
                                                       flashbvh_segment* segment);

#ifdef __cplusplus
}
#endif

#endif
