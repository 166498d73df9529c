// Vectors whose x and y lie in one word, for cores that multiply two halves at once.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/packed_multiply.hpp"
#include "flashbvh/lattice.hpp"

namespace flashbvh::detail {

/// A vertex, an edge or a direction: three signed halves.
struct PackedVector {
  uint32_t xy;  ///< x low, y high
  int32_t z;

  static PackedVector of(const Vertex& v) {
    return {join_halves(static_cast<uint16_t>(v.x), static_cast<uint16_t>(v.y)), v.z};
  }
  int32_t x() const { return static_cast<int16_t>(xy); }
  int32_t y() const { return static_cast<int32_t>(xy) >> 16; }
};

inline PackedVector operator-(const PackedVector& u, const PackedVector& v) {
  return {signed_difference(u.xy, v.xy), u.z - v.z};
}
inline int32_t dot(const PackedVector& u, const PackedVector& v) {
  return add_signed_products(u.z * v.z, u.xy, v.xy);
}

/// The middle of a box, in cells, rounded down.
inline PackedVector middle(const PackedBox& box) {
  return {halved_difference(box.upper_xy, box.lower_xy),
          static_cast<int32_t>(low_half(box.z) - high_half(box.z)) >> 1};
}

/// The squared length, for components within +-32,766.
inline uint32_t squared(const PackedVector& v) {
  const auto square = [](int32_t x) { return static_cast<uint32_t>(x * x); };
  return square(v.x()) + square(v.y()) + square(v.z);
}

}  // namespace flashbvh::detail
