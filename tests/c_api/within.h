/* How many checks of within.c failed. */
#ifndef FLASHBVH_TESTS_C_API_WITHIN_H
#define FLASHBVH_TESTS_C_API_WITHIN_H

#include "flashbvh/clearance.h"
#include "reference.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Of pairs that are kept. */
enum { BAND_ROOM = 24 };

/** Pairs of triangles within a distance, in a query's order, and where each is nearest. */
typedef struct band {
  flashbvh_pair pairs[BAND_ROOM];
  flashbvh_nearest_points nearest[BAND_ROOM];
  flashbvh_counts counts;
  uint32_t count;
  flashbvh_status status;
} band;

/** By C++, in one run. */
void band_in_cpp(image a, image b, const flashbvh_pose* pose, uint32_t distance, band* to);

long within_failures(void);

#ifdef __cplusplus
}
#endif

#endif
