// A 3x3 matrix made for turning boxes.
//
// The bounds of a turned box are sums of products: each entry of the matrix takes the upper bound
// of the box where it is positive and the lower one where it is negative. So the positive and the
// negative part of every entry are kept apart, as halves of words that multiply a packed box's
// words two products at a time (SMLAD on Cortex-M4, M7, M33; PMADDWD on SSE2).
#ifndef FLASHBVH_SPLIT_MATRIX_HPP
#define FLASHBVH_SPLIT_MATRIX_HPP

#include <stdint.h>

#include "flashbvh/packed_multiply.hpp"

namespace flashbvh {

/// Fraction bits of the entries: 1 is 16,384.
constexpr unsigned kSplitBits = 14;
constexpr int32_t kSplitOne = 1 << kSplitBits;

/// One row: what a box's bounds along one axis of the other frame are made of. 12 bytes.
struct SplitRow {
  uint32_t positive_xy;  ///< first column low, second high: the entry, or 0 where it is negative
  uint32_t negative_xy;  ///< the negated entry, or 0 where it is positive
  uint32_t z;            ///< third column: positive part low, negative part high

  static constexpr SplitRow of(int32_t x, int32_t y, int32_t z) {
    return {join_halves(positive(x), positive(y)), join_halves(positive(-x), positive(-y)),
            join_halves(positive(z), positive(-z))};
  }

  constexpr int32_t x() const { return value(low_half(positive_xy), low_half(negative_xy)); }
  constexpr int32_t y() const { return value(high_half(positive_xy), high_half(negative_xy)); }
  constexpr int32_t z_entry() const { return value(low_half(z), high_half(z)); }

  /// The sum of the magnitudes.
  constexpr int32_t sum() const {
    const uint32_t xy = positive_xy + negative_xy;
    return static_cast<int32_t>(low_half(xy) + high_half(xy) + low_half(z) + high_half(z));
  }

 private:
  static constexpr uint32_t positive(int32_t entry) {
    return entry < 0 ? 0u : static_cast<uint32_t>(entry);
  }
  static constexpr int32_t value(uint32_t positive, uint32_t negative) {
    return static_cast<int32_t>(positive) - static_cast<int32_t>(negative);
  }
};

struct SplitMatrix {
  SplitRow row[3];
};

}  // namespace flashbvh

#endif
