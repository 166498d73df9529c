/* flashbvh for C: whether a point lies inside a closed mesh, and whether two bodies have a point in
 * common. solid.hpp says how that is told. Stack on Cortex-M3 to M55 at -O2: 416, 720
 * and 768 bytes. */
#ifndef FLASHBVH_SOLID_H
#define FLASHBVH_SOLID_H

#include "flashbvh/flashbvh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Where a point is. */
typedef enum flashbvh_point_side {
  FLASHBVH_POINT_OUTSIDE = 0,
  FLASHBVH_POINT_ON_SURFACE = 1,
  FLASHBVH_POINT_INSIDE = 2
} flashbvh_point_side;

/** Where `point` is, in cells of the mesh's frame as it was drawn. NOT_CLOSED: the mesh has no
 * inside; `side` is INSIDE then. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_inside(const flashbvh_mesh* mesh,
                                                   const flashbvh_point* point,
                                                   flashbvh_point_side* side);

/** Whether a shell of A or B is inside the other, of bodies whose triangles don't intersect: what
 * is left to ask after a flashbvh_query that ended DONE without a pair. NOT_CLOSED if one of them
 * isn't; after an error `yes` is true. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_one_is_inside(const flashbvh_mesh* a,
                                                          const flashbvh_mesh* b,
                                                          const flashbvh_pose* pose, bool* yes);

/** Whether A and B have any point in common, surfaces and insides. NOT_CLOSED if one of them isn't;
 * after an error `yes` is true. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_solids_intersect(const flashbvh_mesh* a,
                                                             const flashbvh_mesh* b,
                                                             const flashbvh_pose* pose, bool* yes);

#ifdef __cplusplus
}
#endif

#endif
