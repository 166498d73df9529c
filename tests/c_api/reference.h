/* The same query made in C++, of the same images and the same numbers of a pose. */
#ifndef FLASHBVH_TESTS_C_API_REFERENCE_H
#define FLASHBVH_TESTS_C_API_REFERENCE_H

#include "queries.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct image {
  const void* bytes;
  size_t size;
} image;

/** One run to the end. */
void query_in_cpp(image a, image b, const int32_t rotation[9], const int32_t cells[3],
                  const int16_t fraction[3], answer* to);

#ifdef __cplusplus
}
#endif

#endif
