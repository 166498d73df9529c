// The inner step of the rotated box test with SSE2.
#pragma once

#include "sums.hpp"

namespace flashbvh::detail {

/// See arch/rotate_box.hpp.
FLASHBVH_NOINLINE static uint32_t rotate_and_compare(RotatedBox& kept, const PackedBox& box,
                                                     const PackedBox& other) {
  kept.bounds = rotated_sse2(kept.by, box);
  kept.source = &box;
  return compare(kept.bounds, other);
}

}  // namespace flashbvh::detail
