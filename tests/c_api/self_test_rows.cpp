// Self-tests, on a scene's image as constant memory.
#include "c_api/scene.hpp"
#include "flashbvh/flashbvh.h"
#include "flashbvh/self_test.hpp"

namespace flashbvh::test {
namespace {

bool known_answers_agree(Scene&) {
  return same(flashbvh_test_known_pairs(), test_known_pairs()) &&
         same(flashbvh_test_known_distances(), test_known_distances()) &&
         same(flashbvh_test_known_rays(), test_known_rays());
}

bool regions_agree(Scene& s) {
  const MemoryRegion regions[2] = {region_of(s.a.image.data(), s.a.size()),
                                   region_of(s.damaged.data(), 4)};
  flashbvh_memory_region region;
  flashbvh_region_of(s.a.image.data(), s.a.size(), &region);
  flashbvh_region_test c;
  flashbvh_region_test_init(&c, regions, 2);
  RegionTest test(regions, 2);
  s.damaged[0] ^= s.random.below(2);
  bool agree = region.crc == regions[0].crc && flashbvh_sealed_regions() == sealed_regions();
  for (int run = 0; agree && run < 9; ++run) {
    const std::size_t slice = s.random.below(500);
    agree = same(flashbvh_region_test_run(&c, slice), test.run(slice)) &&
            flashbvh_region_test_region(&c) == test.region();
  }
  return agree;
}

}  // namespace

std::vector<Row> self_test_rows() {
  return {{"known answers", known_answers_agree}, {"regions", regions_agree}};
}

}  // namespace flashbvh::test
