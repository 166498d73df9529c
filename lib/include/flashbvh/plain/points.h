/* Points, directions and what is made of them. Of C++ and C alike: `Point` is `flashbvh_point`. */
#ifndef FLASHBVH_PLAIN_POINTS_H
#define FLASHBVH_PLAIN_POINTS_H

#include "flashbvh/plain/language.h"

/** A baked vertex: cells from the mesh's origin, each coordinate within +-16,383. 6 bytes. */
typedef struct flashbvh_vertex {
  int16_t x;
  int16_t y;
  int16_t z;
} flashbvh_vertex;

/** A point in cells, in the frame of mesh A as it was drawn where nothing else is said. */
typedef struct flashbvh_point {
  int32_t x;
  int32_t y;
  int32_t z;
} flashbvh_point;

/** A triangle in cells, in A's frame as it was drawn: its corners may lie on one line or in one
 * point, since rounding to the lattice does that. */
typedef struct flashbvh_triangle {
  flashbvh_point corner[3];
} flashbvh_triangle;

/** A ray from `from` as far as `to`, which may be the same, in cells of the mesh's frame. */
typedef struct flashbvh_segment {
  flashbvh_point from;
  flashbvh_point to;
} flashbvh_segment;

/** A point in 1/256 cell, in A's frame as it was drawn: within +-2^38. */
typedef struct flashbvh_fine_point {
  int64_t x;
  int64_t y;
  int64_t z;
} flashbvh_fine_point;

/** A point in a mesh's unit, in A's frame as it was drawn. */
typedef struct flashbvh_unit_point {
  float x;
  float y;
  float z;
} flashbvh_unit_point;

/** A direction, in 2^-30; of length 1 to four parts in 2^30. */
typedef struct flashbvh_unit_vector {
  int32_t x;
  int32_t y;
  int32_t z;
} flashbvh_unit_vector;

/** Point p of this frame lies at rotation * p + translation in the frame that this one is given in.
 * 48 bytes. */
typedef struct flashbvh_frame {
  int32_t rotation[3][3]; /**< row by row, FLASHBVH_ROTATION_ONE is 1 */
  int32_t translation[3]; /**< in 1/2,048 cell, up to 2^30 */
} flashbvh_frame;

/** (p1 - p0) x (p2 - p0) of a triangle p0, p1, p2: exact, in square cells, twice the area long, not
 * normalised. Each component is within +-57,000^2, below 2^32. Zero for a triangle without area.
 * It points outwards where the mesh winds its triangles counter-clockwise seen from outside. */
typedef struct flashbvh_normal {
  int64_t x;
  int64_t y;
  int64_t z;
} flashbvh_normal;

/** Where two triangles are nearest. */
typedef struct flashbvh_nearest_points {
  flashbvh_fine_point point_a; /**< each coordinate to the nearest 1/256 cell */
  flashbvh_fine_point point_b;
  flashbvh_unit_vector direction; /**< from point_a to point_b; 0 if the triangles intersect */
  uint32_t lower; /**< the distance in 1/256 cell, rounded down; 0 if the triangles intersect */
  uint32_t upper; /**< rounded up */
} flashbvh_nearest_points;

/** What the common part of two triangles may be. */
typedef enum flashbvh_contact_kind {
  FLASHBVH_CONTACT_SEGMENT = 0,   /**< two planes that differ: a segment or a point */
  FLASHBVH_CONTACT_COPLANAR = 1,  /**< one plane: an area, a segment or a point */
  FLASHBVH_CONTACT_DEGENERATE = 2 /**< a triangle without area, its normal is zero: a segment or a
                                     point */
} flashbvh_contact_kind;

/**
 * The common part of two triangles.
 *
 * `ends` are two corners of the common part that are farthest apart, distance being the largest
 * difference along one axis: of a segment its two ends, of an area two opposite corners. Each
 * coordinate is within 0.53 / 256 cell of the exact one, and equal to it where that is a multiple
 * of 1/256, as at a corner of a triangle. Where the triangles have only one point in common, both
 * ends are equal. ends[0] comes before ends[1] by x, then y, then z.
 */
typedef struct flashbvh_contact {
  flashbvh_fine_point ends[2];
  flashbvh_normal normal_a;
  flashbvh_normal normal_b;
  FLASHBVH_BYTE(ContactKind) kind; /**< a flashbvh_contact_kind */
} flashbvh_contact;

#endif
