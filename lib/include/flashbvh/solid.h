/* flashbvh for C: tests if a point is inside a closed mesh, and if two bodies have a point in
 * common. solid.hpp has the method. Stack of the calls, in this order, on Cortex-M3 to M55 at -O2:
 * 416, 720 and 768 bytes. */
#ifndef FLASHBVH_SOLID_H
#define FLASHBVH_SOLID_H

#include "flashbvh/flashbvh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The side of a closed surface on which a point lies. */
typedef enum flashbvh_point_side {
  FLASHBVH_POINT_OUTSIDE = 0,
  FLASHBVH_POINT_ON_SURFACE = 1,
  FLASHBVH_POINT_INSIDE = 2
} flashbvh_point_side;

/** inside(). NOT_CLOSED: `side` is INSIDE. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_inside(const flashbvh_mesh* mesh,
                                                   const flashbvh_point* point,
                                                   flashbvh_point_side* side);

/** one_is_inside(). NOT_CLOSED; after an error `yes` is true. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_one_is_inside(const flashbvh_mesh* a,
                                                          const flashbvh_mesh* b,
                                                          const flashbvh_pose* pose, bool* yes);

/** solids_intersect(). NOT_CLOSED; after an error `yes` is true. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_solids_intersect(const flashbvh_mesh* a,
                                                             const flashbvh_mesh* b,
                                                             const flashbvh_pose* pose, bool* yes);

#ifdef __cplusplus
}
#endif

#endif
