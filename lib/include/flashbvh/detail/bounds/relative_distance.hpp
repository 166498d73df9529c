// The distance of two boxes relative to their sizes: a measure of how deep they lie in each other.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/arch/packed.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"

namespace flashbvh::detail {

/// The distance of the middles of two boxes that overlap, along each axis relative to the lengths
/// of both: 0 to 2^8.
struct RelativeDistance {
  uint32_t x;
  uint32_t y;
  uint32_t z;

  uint32_t squared() const { return x * x + y * y + z * z; }
  uint32_t largest() const {
    const uint32_t xy = x < y ? y : x;
    return xy < z ? z : xy;
  }
};

/// `window`: the lower limits for the words of `box` to overlap the other one. Divides few bits, as
/// some cores divide bit by bit.
FLASHBVH_INLINE_FOR_SPEED inline RelativeDistance relative_distance(const PackedBox& box,
                                                                    const PackedTriple& window) {
  // The overlaps from above and below: their sum is both lengths, their difference two distances.
  const auto relative = [](uint32_t upper, uint32_t lower) {
    const uint32_t apart = upper < lower ? lower - upper : upper - lower;
    return (apart << 8) / (upper + lower + 1);
  };
  const uint32_t upper_xy = box.upper_xy - window.word[0];
  const uint32_t lower_xy = box.lower_xy - window.word[1];
  const uint32_t both_z = box.z - window.word[2];
  return {relative(low_half(upper_xy), low_half(lower_xy)),
          relative(high_half(upper_xy), high_half(lower_xy)),
          relative(low_half(both_z), high_half(both_z))};
}

/// True if a box reaches the lower limits for its words.
FLASHBVH_INLINE inline bool reaches(const PackedBox& box, const PackedTriple& window) {
  return halves_reach({{box.upper_xy, box.lower_xy, box.z}}, window);
}

}  // namespace flashbvh::detail
