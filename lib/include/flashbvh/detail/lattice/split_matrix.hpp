// A 3x3 matrix for rotating boxes.
//
// The bounds of a rotated box are sums of products. A positive entry of the matrix takes the box's
// upper bound, a negative entry the lower bound. So the positive and the negative part of every
// entry are kept apart, as halves of words. These multiply a packed box's words two products at a
// time (SMLAD on Cortex-M4, M7, M33; PMADDWD on SSE2).
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/packed_multiply.hpp"

namespace flashbvh::detail {

/// Fraction bits of the entries: 1 is 16,384.
constexpr unsigned kSplitBits = 14;
constexpr int32_t kSplitOne = 1 << kSplitBits;

/// One row: the factors of a box's bounds along one axis of the other frame. 12 bytes.
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

  /// The sum of the magnitudes, below 2^16.
  constexpr int32_t sum() const {
    const uint32_t xy = positive_xy + negative_xy;
#if defined(__thumb2__)  // adds a half in one instruction
    return static_cast<int32_t>(low_half(xy) + high_half(xy) + low_half(z) + high_half(z));
#else
    const uint32_t both = xy + z;  // magnitudes are 15 bits, and of z's halves one is 0
    return static_cast<int32_t>((both + (both << 16)) >> 16);
#endif
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

  /// A row of the transposed matrix. Exchanges halves; unpacks no entry.
  constexpr SplitRow column(int i) const {
    const auto low = [](uint32_t u, uint32_t v) { return low_half(u) | v << 16; };
    const auto high = [](uint32_t u, uint32_t v) { return u >> 16 | (v & 0xFFFF0000u); };
    const SplitRow& r = row[0];
    const SplitRow& s = row[1];
    const SplitRow& t = row[2];
    switch (i) {
      case 0:
        return {low(r.positive_xy, s.positive_xy), low(r.negative_xy, s.negative_xy),
                low(t.positive_xy, t.negative_xy)};
      case 1:
        return {high(r.positive_xy, s.positive_xy), high(r.negative_xy, s.negative_xy),
                high(t.positive_xy, t.negative_xy)};
      default:
        return {low(r.z, s.z), high(r.z, s.z), t.z};
    }
  }
};

/// Fraction bits kept of a rotation, and of its defect.
constexpr unsigned kRotationBits = 22;
constexpr unsigned kDefectBits = 24;
constexpr unsigned kRestBits = kRotationBits - kSplitBits;

/// A rotation with kRotationBits fraction bits in two parts, so that all factors of a vertex's
/// products have 16 bits. 48 bytes.
struct RotationMatrix {
  SplitMatrix rows;   ///< the leading bits, which rotate boxes
  int8_t rest[3][3];  ///< the bits that `rows` lack, in 2^-kRotationBits: -128 to 127
  /// A bound on the spectral norm of R^T R - 1, in 2^-kDefectBits. R R^T - 1 has an equal norm, so
  /// the bound also holds for the inverse.
  uint16_t defect;

  /// Gets a row with all its bits.
  constexpr void get_row(int i, int32_t& x, int32_t& y, int32_t& z) const {
    constexpr int32_t one = 1 << kRestBits;
    x = rows.row[i].x() * one + rest[i][0];
    y = rows.row[i].y() * one + rest[i][1];
    z = rows.row[i].z_entry() * one + rest[i][2];
  }
};

}  // namespace flashbvh::detail
