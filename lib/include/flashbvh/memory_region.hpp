// Checksums of memory that must not change: firmware's code and constants, images in flash, a
// workcell's memory.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/status.hpp"

namespace flashbvh {

/// Bytes with a known checksum.
struct MemoryRegion {
  const void* begin;
  size_t size;   ///< bytes
  uint32_t crc;  ///< CRC-32 (IEEE 802.3), as in images and zlib; 0 for no bytes
};

/// Returns a region with its current checksum. For an image that was opened, whose own checksum
/// held; for a workcell's memory after each change.
[[nodiscard]] MemoryRegion region_of(const void* begin, size_t size);

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
