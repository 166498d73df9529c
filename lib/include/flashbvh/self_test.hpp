// Self-tests of firmware: known answers, which find broken arithmetic, and checksums of constant
// memory, which find damaged code and data.
//
// A known-answer test runs a part of the library on built-in meshes and poses, and compares all
// answers and the work spent. Call the tests of the parts that the firmware uses: no others are
// linked. No test keeps memory. Not tested: triangles with an edge of more than 32,700 cells,
// deformable meshes, shapes and motions. Broken arithmetic may keep a test from ending, so call it
// under the watchdog.
#ifndef FLASHBVH_SELF_TEST_HPP
#define FLASHBVH_SELF_TEST_HPP

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/plain/memory_region.h"
#include "flashbvh/status.hpp"

namespace flashbvh {

// Each returns `done` or `self_test_failed`. Figures are those of a Cortex-M4F at -O2.

/// Tests PairQuery in slices, translated and rotated, with each pair that intersects. 890,000
/// instructions, 1,152 bytes of stack.
Status test_known_pairs();
/// Tests distance() and closer_than(), with nearest points. 2,300,000 instructions, 1.6 KB of
/// stack.
Status test_known_distances();
/// Tests nearest_hit() and inside(). 130,000 instructions, 0.8 KB of stack.
Status test_known_rays();

using MemoryRegion = flashbvh_memory_region;

/// Returns a region with its current checksum. For an image that was opened, whose own checksum
/// held; for a workcell's memory after each change.
[[nodiscard]] MemoryRegion region_of(const void* begin, size_t size);

constexpr uint32_t kSealedRegions = FLASHBVH_SEALED_REGIONS;
/// Returns kSealedRegions regions: the code and constants of this firmware, as
/// tools/seal_firmware.py wrote them into its ELF file. Until then a test of them fails.
const MemoryRegion* sealed_regions();

/// Checks regions repeatedly, in slices.
class RegionTest {
 public:
  /// `regions`: `count` regions, which must outlive the test.
  constexpr RegionTest(const MemoryRegion* regions, uint32_t count)
      : regions_(regions), count_(count) {}

  /// Checks up to `bytes` more; SIZE_MAX: all. `suspended`; `done`: each region holds, and the next
  /// run starts with the first; `self_test_failed`, also from each later run. 10 instructions a
  /// byte on a Cortex-M4F.
  Status run(size_t bytes);

  /// Returns the number of the region that is being checked, or that has failed.
  uint32_t region() const { return region_; }

 private:
  const MemoryRegion* regions_;
  uint32_t count_;
  uint32_t region_ = 0;
  size_t checked_ = 0;  ///< checked bytes of the region
  uint32_t crc_ = 0;    ///< checksum of these bytes
  uint32_t has_failed_ = 0;
};

}  // namespace flashbvh

#endif
