// Self-tests of firmware: known answers, which find broken arithmetic, and checksums of constant
// memory, which find damaged code and data.
//
// A known-answer test runs a part of the library on meshes and poses of its own, and compares all
// answers and the work that they took. Call the tests of those parts that the firmware uses: no
// other is linked. None keeps memory. Not run are triangles with an edge of more than 32,700 cells,
// meshes that bend, shapes, and motions. Broken arithmetic may keep a test from ending, so call it
// under the watchdog.
#ifndef FLASHBVH_SELF_TEST_HPP
#define FLASHBVH_SELF_TEST_HPP

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/plain/memory_region.h"
#include "flashbvh/status.hpp"

namespace flashbvh {

// `done` or `self_test_failed`. Figures are those of a Cortex-M4F at -O2.

/// PairQuery, in slices: translated and rotated, each pair that intersects. 890,000
/// instructions, 1,152 bytes of stack.
Status test_known_pairs();
/// distance() and closer_than(), with nearest points. 2,300,000 instructions, 1.6 KB of
/// stack.
Status test_known_distances();
/// nearest_hit() and inside(). 130,000 instructions, 0.8 KB of stack.
Status test_known_rays();

using MemoryRegion = flashbvh_memory_region;

/// With the checksum that it has now: of an image that was opened, whose own checksum held; of a
/// workcell's memory after it was changed.
[[nodiscard]] MemoryRegion region_of(const void* begin, size_t size);

constexpr uint32_t kSealedRegions = FLASHBVH_SEALED_REGIONS;
/// kSealedRegions of them: the code and constants of this firmware, as tools/seal_firmware.py wrote
/// them into its ELF file. Before that, a test of them fails.
const MemoryRegion* sealed_regions();

/// Checks regions again and again, in slices.
class RegionTest {
 public:
  /// `regions`: `count` of them, which outlive it.
  constexpr RegionTest(const MemoryRegion* regions, uint32_t count)
      : regions_(regions), count_(count) {}

  /// Checks so many bytes more; SIZE_MAX: all. `suspended`; `done`: each region holds, and the next
  /// run begins with the first one again; `self_test_failed`, of each later run, too. 10
  /// instructions a byte on a Cortex-M4F.
  Status run(size_t bytes);

  /// The number of the region that is being checked, or that has failed.
  uint32_t region() const { return region_; }

 private:
  const MemoryRegion* regions_;
  uint32_t count_;
  uint32_t region_ = 0;
  size_t checked_ = 0;  ///< bytes of the region
  uint32_t crc_ = 0;    ///< of those
  uint32_t has_failed_ = 0;
};

}  // namespace flashbvh

#endif
