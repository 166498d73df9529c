// The regions of the linked firmware.
#include "flashbvh/self_test.hpp"

/// Until tools/seal_firmware.py writes them: the first one fails. Its name is what that looks for.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" const flashbvh::MemoryRegion flashbvh_sealed_region_list[flashbvh::kSealedRegions] = {
    {nullptr, 0, 1}};

namespace flashbvh {

/// No compiler may work with the list as it was compiled.
const MemoryRegion* sealed_regions() {
  const MemoryRegion* regions = flashbvh_sealed_region_list;
  asm("" : "+r"(regions));
  return regions;
}

}  // namespace flashbvh
