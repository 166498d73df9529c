// The C interface to self-tests.
#include "flashbvh/flashbvh.h"

#include "flashbvh/self_test.hpp"
#include "objects.hpp"

using namespace flashbvh;

FLASHBVH_HOLDS(flashbvh_region_test, RegionTest);

flashbvh_status flashbvh_test_known_pairs(void) {
  return c_status(test_known_pairs());
}

flashbvh_status flashbvh_test_known_distances(void) {
  return c_status(test_known_distances());
}

flashbvh_status flashbvh_test_known_rays(void) {
  return c_status(test_known_rays());
}

void flashbvh_region_of(const void* begin, size_t size, flashbvh_memory_region* region) {
  put(region, [&] { return region_of(begin, size); });
}

const flashbvh_memory_region* flashbvh_sealed_regions(void) {
  return sealed_regions();
}

void flashbvh_region_test_init(flashbvh_region_test* test, const flashbvh_memory_region* regions,
                               uint32_t count) {
  (void)make(test, regions, count);
}

flashbvh_status flashbvh_region_test_run(flashbvh_region_test* test, size_t bytes) {
  return c_status(object_in(test).run(bytes));
}

uint32_t flashbvh_region_test_region(const flashbvh_region_test* test) {
  return object_in(test).region();
}
