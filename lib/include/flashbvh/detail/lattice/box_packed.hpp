// Arithmetic of packed boxes.
//
// Each bound is a number from 1 to 32,767. The sum of two bounds is then at most 65,534: two of
// them fit in a 32-bit addition without carry from one to the other.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/packed.hpp"
#include "flashbvh/lattice.hpp"

namespace flashbvh::detail {

/// Lower limits, half by half, for the words upper_xy, lower_xy and z of a box, so that its sums
/// with `other`, as in box.hpp, reach `least`. Limits fit halves: no box reaches one whose `least`
/// is 65,535.
inline PackedTriple window(const PackedTriple& least, const PackedBox& other) {
  return {{subtract_halves(least.word[1], other.lower_xy),
           subtract_halves(least.word[0], other.upper_xy),
           swap_halves(subtract_halves(least.word[2], other.z))}};
}

/// Compares two boxes on one lattice: 0 if they overlap. They overlap if no sum of an upper and a
/// negated lower bound is negative, that is, below its bias, which is the top bit.
constexpr uint32_t compare(const PackedBox& a, const PackedBox& b) {
  constexpr uint32_t biases = 0x80008000u;
  return biases &
         ~((a.upper_xy + b.lower_xy) & (a.lower_xy + b.upper_xy) & (a.z + swap_halves(b.z)));
}

/// The largest magnitude of a coordinate between these bounds.
constexpr int32_t reach(uint32_t upper, uint32_t lower) {
  return static_cast<int32_t>(upper > lower ? upper : lower) - kBoundBias;
}
/// The sum of the largest magnitudes of x, y and z in the box: no point of it, however rotated, has
/// a larger coordinate.
constexpr int32_t reach(const PackedBox& box) {
  return reach(low_half(box.upper_xy), low_half(box.lower_xy)) +
         reach(high_half(box.upper_xy), high_half(box.lower_xy)) +
         reach(low_half(box.z), high_half(box.z));
}

/// Length of the box along x, y or z in cells, 0 to 2 * kMaxCoordinate.
constexpr uint32_t extent_x(const PackedBox& box) {
  return low_half(box.upper_xy) + low_half(box.lower_xy) - 2 * kBoundBias;
}
constexpr uint32_t extent_y(const PackedBox& box) {
  return high_half(box.upper_xy) + high_half(box.lower_xy) - 2 * kBoundBias;
}
constexpr uint32_t extent_z(const PackedBox& box) {
  return low_half(box.z) + high_half(box.z) - 2 * kBoundBias;
}
/// The sum of the three lengths.
constexpr uint32_t extent(const PackedBox& box) {
  return extent_x(box) + extent_y(box) + extent_z(box);
}

}  // namespace flashbvh::detail
