// The sums of a rotated box for cores that multiply one pair of numbers at a time: those of
// portable/rotate_box.hpp without the products that are 0. One of an entry's positive and negative
// parts is 0: a branch on it leaves two products of four.
#pragma once

#include "flashbvh/detail/bounds/box_rotated.hpp"

namespace flashbvh::detail {

using Half [[gnu::may_alias]] = uint16_t;

/// Loads a half of a word alone: compilers would load the word and take it apart.
inline uint32_t loaded_half(const uint32_t& word, int which) {
  return reinterpret_cast<const Half*>(&word)[which];
}

/// Sets a half of a word. The empty assembly keeps GCC from cutting `half` to 16 bits, as the store
/// does so.
inline void store_half(uint32_t& word, int which, uint32_t half) {
#if defined(__GNUC__)
  __asm__("" : "+r"(half));
#endif
  reinterpret_cast<Half*>(&word)[which] = static_cast<Half>(half);
}

/// An upper and a negated lower bound, biased.
struct AxisBounds {
  uint32_t upper;
  uint32_t lower;
};

/// The sums that become the bounds of a rotated box along one axis.
struct AxisSums {
  uint32_t upper;
  uint32_t lower;

  /// Adds the products of an entry's positive part or, if that is 0, of its negative part.
  FLASHBVH_INLINE_FOR_SPEED void add(const uint32_t& positives, int positive,
                                     const uint32_t& negatives, int negative,
                                     const AxisBounds& bounds) {
    uint32_t entry = loaded_half(positives, positive);
    if (entry != 0) {
      upper += entry * bounds.upper;
      lower += entry * bounds.lower;
    } else {
      entry = loaded_half(negatives, negative);
      upper += entry * bounds.lower;
      lower += entry * bounds.upper;
    }
  }
};

/// Clamps a sum to the range from 0 to the last cell.
inline uint32_t clamped_sum(uint32_t sum) {
  constexpr uint32_t most = 0x7FFFu << kSplitBits;
  return sum >> 31 != 0 ? 0 : sum > most ? most : sum;
}

/// Rounds sums down to whole cells, clamped to 0 and 32,767. One test for both, as bounds outside
/// the lattice are rare.
inline AxisBounds whole_bounds(AxisSums sums) {
  if (__builtin_expect((sums.upper | sums.lower) >> (15 + kSplitBits) != 0, 0)) {
    sums = {clamped_sum(sums.upper), clamped_sum(sums.lower)};
  }
  return {sums.upper >> kSplitBits, sums.lower >> kSplitBits};
}

/// Returns the sums along the axis of `row`, for a box with bounds `x`, `y` and `z`.
FLASHBVH_INLINE inline AxisSums rotated_sums(const SplitRow& row, const BoxTestStart& start,
                                             const AxisBounds& x, const AxisBounds& y,
                                             const AxisBounds& z) {
  AxisSums sums = {static_cast<uint32_t>(start.upper), static_cast<uint32_t>(start.lower)};
  sums.add(row.positive_xy, 0, row.negative_xy, 0, x);
  sums.add(row.positive_xy, 1, row.negative_xy, 1, y);
  sums.add(row.z, 0, row.z, 1, z);
  return sums;
}

/// Sets `bounds` to those of `box` rotated by `matrix`; sums begin at `starts`. Each half is stored
/// at once, so that RISC-V's registers suffice for the rest.
FLASHBVH_INLINE inline void rotate_plain(const SplitMatrix& matrix, const BoxTestStart* starts,
                                         const PackedBox& box, PackedBox& bounds) {
  const AxisBounds x = {loaded_half(box.upper_xy, 0), loaded_half(box.lower_xy, 0)};
  const AxisBounds y = {loaded_half(box.upper_xy, 1), loaded_half(box.lower_xy, 1)};
  const AxisBounds z = {loaded_half(box.z, 0), loaded_half(box.z, 1)};
  const AxisBounds on_x = whole_bounds(rotated_sums(matrix.row[0], starts[0], x, y, z));
  store_half(bounds.upper_xy, 0, on_x.upper);
  store_half(bounds.lower_xy, 0, on_x.lower);
  const AxisBounds on_y = whole_bounds(rotated_sums(matrix.row[1], starts[1], x, y, z));
  store_half(bounds.upper_xy, 1, on_y.upper);
  store_half(bounds.lower_xy, 1, on_y.lower);
  const AxisBounds on_z = whole_bounds(rotated_sums(matrix.row[2], starts[2], x, y, z));
  store_half(bounds.z, 0, on_z.upper);
  store_half(bounds.z, 1, on_z.lower);
}

}  // namespace flashbvh::detail
