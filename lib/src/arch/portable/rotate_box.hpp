// The inner step of the rotated box test: the reference of the forms for single cores.
#pragma once

#include "flashbvh/detail/arch/packed_multiply.hpp"
#include "flashbvh/detail/bounds/box_rotated.hpp"

namespace flashbvh::detail {

/// Rounds a biased bound down to whole cells, clamped to the lattice: against a box on the lattice
/// that decides alike.
inline uint32_t whole_bound(int32_t bound) {
  return saturated<15>(bound >> kSplitBits);
}

inline uint32_t upper_bound(const SplitRow& row, int32_t start, const PackedBox& box) {
  return whole_bound(add_products(add_products(add_products(start, row.positive_xy, box.upper_xy),
                                               row.negative_xy, box.lower_xy),
                                  row.z, box.z));
}

inline uint32_t lower_bound(const SplitRow& row, int32_t start, const PackedBox& box) {
  return whole_bound(
      add_crossed_products(add_products(add_products(start, row.positive_xy, box.lower_xy),
                                        row.negative_xy, box.upper_xy),
                           row.z, box.z));
}

/// Returns the bounds of a rotated box on the other lattice.
inline PackedBox rotated_portable(const SplitMatrix& matrix, const BoxTestStart* starts,
                                  const PackedBox& box) {
  const auto upper = [&](int i) { return upper_bound(matrix.row[i], starts[i].upper, box); };
  const auto lower = [&](int i) { return lower_bound(matrix.row[i], starts[i].lower, box); };
  return {join_halves(upper(0), upper(1)), join_halves(lower(0), lower(1)),
          join_halves(upper(2), lower(2))};
}

/// See arch/rotate_box.hpp.
FLASHBVH_NOINLINE static uint32_t rotate_and_compare(RotatedBox& kept, const PackedBox& box,
                                                     const PackedBox& other) {
  kept.bounds = rotated_portable(*kept.by.matrix, kept.by.starts, box);
  kept.source = &box;
  return compare(kept.bounds, other);
}

}  // namespace flashbvh::detail
