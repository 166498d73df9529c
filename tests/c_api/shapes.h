/* Shapes made in C, and the same made in C++. */
#ifndef FLASHBVH_TESTS_C_API_SHAPES_H
#define FLASHBVH_TESTS_C_API_SHAPES_H

#include "reference.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A point, a segment, a triangle, a box. */
enum { SHAPES = 4 };

/** What is asked of a shape and a mesh. */
typedef struct shape_answer {
  uint32_t lower; /**< their distance */
  uint32_t upper;
  uint32_t pairs; /**< of triangles that intersect */
} shape_answer;

/** The shapes of the first corners of a triangle, as many as each takes, against a mesh: made in
 * C++. */
void ask_shapes_in_cpp(image mesh, const flashbvh_triangle* of, const int32_t rotation[9],
                       const int32_t cells[3], shape_answer to[SHAPES]);

/** How many checks of shapes.c failed. */
long shape_failures(void);

#ifdef __cplusplus
}
#endif

#endif
