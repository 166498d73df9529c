// The inner step of the rotated box test for cores that multiply one pair of numbers at a time.
#pragma once

#include "sums.hpp"

namespace flashbvh::detail {

/// See arch/rotate_box.hpp.
FLASHBVH_NOINLINE static uint32_t rotate_and_compare(RotatedBox& kept, const PackedBox& box,
                                                     const PackedBox& other) {
  rotate_plain(*kept.by.matrix, kept.by.starts, box, kept.bounds);
  kept.source = &box;
  return compare(kept.bounds, other);
}

}  // namespace flashbvh::detail
