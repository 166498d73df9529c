/* flashbvh for C: points, segments, triangles and boxes made at run time, in the caller's memory. A
 * sphere is a point and a distance, a capsule a segment and a distance: see shape.hpp.
 *
 * A shape's `mesh` is a mesh of one leaf, for every call that takes an opened mesh:
 *     flashbvh_closer_than(&part, &capsule.mesh, &pose, radius, &yes)
 *
 * A shape points into itself. It must not be copied, not even by assignment, and must not move
 * while queries use it. To move it, use a pose, or make it again in place, which ends its queries.
 *
 * Coordinates are in cells of the shape's own frame. Stack on Cortex-M3 to M55 at -O2: 352 bytes
 * (proofs/stack). */
#ifndef FLASHBVH_SHAPE_H
#define FLASHBVH_SHAPE_H

#include "flashbvh/flashbvh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A point. 104 bytes on a 32-bit core, 128 on a 64-bit one. */
typedef struct flashbvh_point_shape {
  flashbvh_mesh mesh; /**< for queries */
  unsigned char opaque[40];
} flashbvh_point_shape;

/** A segment. 112 bytes on a 32-bit core, 136 on a 64-bit one. */
typedef struct flashbvh_segment_shape {
  flashbvh_mesh mesh; /**< for queries */
  unsigned char opaque[48];
} flashbvh_segment_shape;

/** A triangle. 120 bytes on a 32-bit core, 144 on a 64-bit one. */
typedef struct flashbvh_triangle_shape {
  flashbvh_mesh mesh; /**< for queries */
  unsigned char opaque[56];
} flashbvh_triangle_shape;

/** A closed box. 232 bytes on a 32-bit core, 256 on a 64-bit one. */
typedef struct flashbvh_box_shape {
  flashbvh_mesh mesh; /**< for queries */
  unsigned char opaque[168];
} flashbvh_box_shape;

/** PointShape: makes it, or makes it again. Takes the cell and the unit of `like`, which need not
 * outlive it. SHAPE_TOO_LARGE: queries of the shape then end with CELL_MISMATCH. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_point_shape_make(flashbvh_point_shape* shape,
                                                             const flashbvh_mesh* like,
                                                             const flashbvh_point* at);

/** SegmentShape, from `p` to `q`. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_segment_shape_make(flashbvh_segment_shape* shape,
                                                               const flashbvh_mesh* like,
                                                               const flashbvh_point* p,
                                                               const flashbvh_point* q);

/** TriangleShape. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_triangle_shape_make(flashbvh_triangle_shape* shape,
                                                                const flashbvh_mesh* like,
                                                                const flashbvh_triangle* triangle);

/** BoxShape: `lower` must not exceed `upper` along any axis. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_box_shape_make(flashbvh_box_shape* shape,
                                                           const flashbvh_mesh* like,
                                                           const flashbvh_point* lower,
                                                           const flashbvh_point* upper);

#ifdef __cplusplus
}
#endif

#endif
