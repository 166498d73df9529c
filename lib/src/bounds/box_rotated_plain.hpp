// The inner step of the rotated box test for cores that multiply one pair of numbers at a time: the
// sums of box_rotated.cpp without the products that are zero. Of the positive and the negative part
// of an entry one is zero; which one is tested, and two products do instead of four.
#ifndef FLASHBVH_BOUNDS_BOX_ROTATED_PLAIN_HPP
#define FLASHBVH_BOUNDS_BOX_ROTATED_PLAIN_HPP

#include "flashbvh/detail/bounds/box_rotated.hpp"

namespace flashbvh::detail {

using Half [[gnu::may_alias]] = uint16_t;

/// A half of a word, loaded alone: compilers would load the word and take it apart.
inline uint32_t loaded_half(const uint32_t& word, int which) {
  return reinterpret_cast<const Half*>(&word)[which];
}

/// Sets a half of a word. That `half` may have changed keeps GCC from cutting it to 16 bits, which
/// storing does.
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

  void add_positive(uint32_t entry, const AxisBounds& bounds) {
    upper += entry * bounds.upper;
    lower += entry * bounds.lower;
  }
  void add_negative(uint32_t negated_entry, const AxisBounds& bounds) {
    upper += negated_entry * bounds.lower;
    lower += negated_entry * bounds.upper;
  }
};

/// A sum kept from 0 to that of the last cell.
inline uint32_t clamped_sum(uint32_t sum) {
  constexpr uint32_t most = 0x7FFFu << kSplitBits;
  return sum >> 31 != 0 ? 0 : sum > most ? most : sum;
}

/// Whole cells from 0 to 32,767. Bounds are seldom outside the lattice: one test for both.
inline AxisBounds whole_bounds(AxisSums sums) {
  if (__builtin_expect((sums.upper | sums.lower) >> (15 + kSplitBits), 0) != 0) {
    sums = {clamped_sum(sums.upper), clamped_sum(sums.lower)};
  }
  return {sums.upper >> kSplitBits, sums.lower >> kSplitBits};
}

/// The sums along the axis of `row` of a box with bounds `x`, `y` and `z`.
[[gnu::always_inline]] inline AxisSums rotated_sums(const SplitRow& row, const BoxTestStart& start,
                                                    const AxisBounds& x, const AxisBounds& y,
                                                    const AxisBounds& z) {
  AxisSums sums = {static_cast<uint32_t>(start.upper), static_cast<uint32_t>(start.lower)};
  const auto add = [&sums](const uint32_t& positives, int positive, const uint32_t& negatives,
                           int negative, const AxisBounds& bounds) {
    const uint32_t entry = loaded_half(positives, positive);
    if (entry != 0) {
      sums.add_positive(entry, bounds);
    } else {
      sums.add_negative(loaded_half(negatives, negative), bounds);
    }
  };
  add(row.positive_xy, 0, row.negative_xy, 0, x);
  add(row.positive_xy, 1, row.negative_xy, 1, y);
  add(row.z, 0, row.z, 1, z);
  return sums;
}

/// Sets `bounds` to those of `box` rotated by `matrix`, its sums beginning at `starts`. They are
/// stored at once, by halves: then RISC-V has registers for everything else.
[[gnu::always_inline]] inline void rotate_plain(const SplitMatrix& matrix,
                                                const BoxTestStart* starts, const PackedBox& box,
                                                PackedBox& bounds) {
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

#endif
