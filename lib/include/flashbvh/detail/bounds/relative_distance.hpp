// Distances of boxes from one box relative to their sizes: a measure of how deep they lie in it.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"
#include "flashbvh/detail/lattice/packed_vector.hpp"

namespace flashbvh::detail {

/// The distance of two boxes' middles, along each axis relative to the lengths of both boxes.
class RelativeDistance {
 public:
  explicit RelativeDistance(const PackedBox& from)
      : middle_(middle(from)), x_(extent_x(from)), y_(extent_y(from)), z_(extent_z(from)) {}

  /// The squared distance, in 2^-16. Overlapping boxes have at most a quarter along each axis.
  FLASHBVH_INLINE uint32_t squared_to(const PackedBox& box) const {
    const PackedVector to = middle(box) - middle_;
    return square(to.x(), x_ + extent_x(box)) + square(to.y(), y_ + extent_y(box)) +
           square(to.z, z_ + extent_z(box));
  }

 private:
  /// Divides few bits, as some cores divide bit by bit.
  FLASHBVH_INLINE static uint32_t square(int32_t distance, uint32_t lengths) {
    const auto size = static_cast<uint32_t>(distance < 0 ? -distance : distance);
    const uint32_t relative = (size << 8) / (lengths + 1);
    return relative * relative;
  }

  PackedVector middle_;
  uint32_t x_;
  uint32_t y_;
  uint32_t z_;
};

}  // namespace flashbvh::detail
