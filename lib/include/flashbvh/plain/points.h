/* Points, directions and types made of them. For C and C++: `Point` is `flashbvh_point`. */
#pragma once

#include "flashbvh/plain/language.h"

/** A baked vertex in cells, relative to the mesh's origin; coordinates within +-16,383. 6 bytes. */
typedef struct flashbvh_vertex {
  int16_t x;
  int16_t y;
  int16_t z;
} flashbvh_vertex;

/** A point in cells; unless stated otherwise, in mesh A's source frame, that of its file. */
typedef struct flashbvh_point {
  int32_t x;
  int32_t y;
  int32_t z;
} flashbvh_point;

/** A triangle in cells of A's source frame. Its corners may be collinear or equal, since rounding
 * to the lattice can make them so. */
typedef struct flashbvh_triangle {
  flashbvh_point corner[3];
} flashbvh_triangle;

/** A ray from `from` to `to`, which may be equal, in cells of the mesh's frame. */
typedef struct flashbvh_segment {
  flashbvh_point from;
  flashbvh_point to;
} flashbvh_segment;

/** A length in 1/256 cell. A type of its own, so that no length in a mesh's unit is taken for it.
 */
typedef struct flashbvh_fine_length {
  uint32_t count;
} flashbvh_fine_length;

/** A point in 1/256 cell of A's source frame: within +-2^38. */
typedef struct flashbvh_fine_point {
  int64_t x;
  int64_t y;
  int64_t z;
} flashbvh_fine_point;

/** A point in a mesh's unit, in A's source frame. */
typedef struct flashbvh_unit_point {
  float x;
  float y;
  float z;
} flashbvh_unit_point;

/** A direction, in 2^-30; its length is 1 within four parts in 2^30. */
typedef struct flashbvh_unit_vector {
  int32_t x;
  int32_t y;
  int32_t z;
} flashbvh_unit_vector;

/** A frame relative to an outer frame: its point p is at rotation * p + translation in the outer
 * frame. 48 bytes. */
typedef struct flashbvh_frame {
  int32_t rotation[3][3]; /**< row by row, FLASHBVH_ROTATION_ONE is 1 */
  int32_t translation[3]; /**< in 1/2,048 cell, within +-2^30 */
} flashbvh_frame;

/** (p1 - p0) x (p2 - p0) of a triangle p0, p1, p2: exact, in square cells, twice the area long, not
 * normalised. Each component is within +-57,000^2, below 2^32; zero for a triangle without area. It
 * points outwards if the mesh's triangles wind counter-clockwise seen from outside. */
typedef struct flashbvh_normal {
  int64_t x;
  int64_t y;
  int64_t z;
} flashbvh_normal;

/** The nearest points of two triangles. */
typedef struct flashbvh_nearest_points {
  flashbvh_fine_point point_a; /**< each coordinate to the nearest 1/256 cell */
  flashbvh_fine_point point_b;
  flashbvh_unit_vector direction; /**< from point_a to point_b; 0 if the triangles intersect */
  uint32_t lower; /**< the distance in 1/256 cell, rounded down; 0 if the triangles intersect */
  uint32_t upper; /**< rounded up */
} flashbvh_nearest_points;

/** Kinds of the common part of two triangles. */
typedef enum flashbvh_contact_kind {
  FLASHBVH_CONTACT_SEGMENT = 0,   /**< the planes differ: a segment or a point */
  FLASHBVH_CONTACT_COPLANAR = 1,  /**< one common plane: an area, a segment or a point */
  FLASHBVH_CONTACT_DEGENERATE = 2 /**< a triangle has no area and a zero normal: a segment or a
                                     point */
} flashbvh_contact_kind;

/** The common part of two triangles.
 *
 * `ends` are two corners of the common part that are farthest apart, by the largest difference
 * along one axis: a segment's two ends, or an area's two opposite corners. Each coordinate is
 * within 0.53 / 256 cell of the exact one, and exact if that is a multiple of 1/256, as at a
 * triangle's corner. If the triangles have only one common point, both ends are equal. ends[0]
 * precedes ends[1] by x, then y, then z. */
typedef struct flashbvh_contact {
  flashbvh_fine_point ends[2];
  flashbvh_normal normal_a;
  flashbvh_normal normal_b;
  FLASHBVH_BYTE(ContactKind) kind; /**< a flashbvh_contact_kind */
} flashbvh_contact;
