// Checks constant memory in slices.
#include "flashbvh/memory_region.hpp"
#include "flashbvh/detail/lattice/image_parts.hpp"

namespace flashbvh {

MemoryRegion region_of(const void* begin, size_t size) {
  return {begin, size, detail::crc32(begin, size)};
}

Status RegionTest::run(size_t bytes) {
  while (!has_failed_ && region_ < count_) {
    const MemoryRegion& region = regions_[region_];
    const size_t left = region.size - checked_;
    const size_t slice = left < bytes ? left : bytes;
    if (checked_ <= region.size) {  // else the list of regions is damaged
      crc_ = detail::crc32(static_cast<const unsigned char*>(region.begin) + checked_, slice, crc_);
      checked_ += slice;
      bytes -= slice;
      if (checked_ != region.size) {
        return Status::suspended;
      }
    }
    has_failed_ = checked_ != region.size || crc_ != region.crc;
    region_ += has_failed_ ? 0 : 1;
    checked_ = crc_ = 0;
  }
  if (has_failed_) {
    return Status::self_test_failed;
  }
  region_ = 0;
  return Status::done;
}

}  // namespace flashbvh
