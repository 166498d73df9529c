/* flashbvh for C: self-tests of firmware. See self_test.hpp. */
#ifndef FLASHBVH_SELF_TEST_H
#define FLASHBVH_SELF_TEST_H

#include "flashbvh/plain/language.h"
#include "flashbvh/plain/memory_region.h"
#include "flashbvh/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** test_known_pairs(). DONE or SELF_TEST_FAILED, as from all tests. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_test_known_pairs(void);
/** test_known_distances(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_test_known_distances(void);
/** test_known_rays(). */
FLASHBVH_NODISCARD flashbvh_status flashbvh_test_known_rays(void);

/** region_of(). */
void flashbvh_region_of(const void* begin, size_t size, flashbvh_memory_region* region);

/** sealed_regions(): FLASHBVH_SEALED_REGIONS regions. */
const flashbvh_memory_region* flashbvh_sealed_regions(void);

/** RegionTest. */
FLASHBVH_OPAQUE(flashbvh_region_test, 3, 16, void*);

/** `regions`: `count` regions, which must outlive the test. */
void flashbvh_region_test_init(flashbvh_region_test* test, const flashbvh_memory_region* regions,
                               uint32_t count);

/** RegionTest::run(): `bytes` more at most; SIZE_MAX: all. SUSPENDED; DONE; SELF_TEST_FAILED. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_region_test_run(flashbvh_region_test* test,
                                                            size_t bytes);

/** RegionTest::region(): the number of the region that is being checked, or that has failed. */
uint32_t flashbvh_region_test_region(const flashbvh_region_test* test);

#ifdef __cplusplus
}
#endif

#endif
