// Axis-aligned boxes on the lattice, and the test whether two of them overlap.
//
// A packed box keeps, per axis, the upper bound and the negated lower bound, each raised by
// kBoundBias so that it is a number from 1 to 32,767. Box A overlaps box B moved by t if on each
// axis
//     upper(A) - lower(B) >= t    and    upper(B) - lower(A) >= -t,
// that is, if six sums of two packed bounds reach six thresholds that depend on the translation
// alone. A sum of two bounds is at most 65,534: it never leaves its 16 bits, so two of them fit in
// a 32-bit addition and no form of the arithmetic wraps or saturates.
#ifndef FLASHBVH_BOX_HPP
#define FLASHBVH_BOX_HPP

#include <stdint.h>

#include "flashbvh/lattice.hpp"
#include "flashbvh/packed.hpp"

namespace flashbvh {

/// Raises a bound (or a negated one) to a positive number of 15 bits.
constexpr int32_t kBoundBias = kMaxCoordinate + 1;

static_assert(2 * (kMaxCoordinate + kBoundBias) <= 0xFFFF, "sums of two bounds fit 16 bits");

/// A closed box: all points with lower <= coordinate <= upper, in cells.
struct Box {
  Vertex lower;
  Vertex upper;
};

/// A box as it lies in flash: 12 bytes, low half first.
struct PackedBox {
  uint32_t upper_xy;  ///< upper x, upper y
  uint32_t lower_xy;  ///< negated lower x, negated lower y
  uint32_t z;         ///< upper z, negated lower z
};

constexpr uint32_t pack_bound(int32_t bound) {
  return static_cast<uint32_t>(bound + kBoundBias);
}

constexpr PackedBox pack(const Box& box) {
  return {join_halves(pack_bound(box.upper.x), pack_bound(box.upper.y)),
          join_halves(pack_bound(-box.lower.x), pack_bound(-box.lower.y)),
          join_halves(pack_bound(box.upper.z), pack_bound(-box.lower.z))};
}

constexpr int16_t unpack_bound(uint32_t half) {
  return static_cast<int16_t>(static_cast<int32_t>(half) - kBoundBias);
}

constexpr Box unpack(const PackedBox& packed) {
  const Vertex upper = {unpack_bound(low_half(packed.upper_xy)),
                        unpack_bound(high_half(packed.upper_xy)), unpack_bound(low_half(packed.z))};
  const auto lower = [](uint32_t half) {
    return static_cast<int16_t>(kBoundBias - static_cast<int32_t>(half));
  };
  return {{lower(low_half(packed.lower_xy)), lower(high_half(packed.lower_xy)),
           lower(high_half(packed.z))},
          upper};
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

/// Whether two boxes, the second moved by a translation, are apart along one axis; `upper` and
/// `lower` are halves of packed boxes. For a single test, which the thresholds would not pay.
constexpr bool apart_along(uint32_t upper_a, uint32_t lower_a, uint32_t upper_b, uint32_t lower_b,
                           int32_t t) {
  constexpr int32_t zero = 2 * kBoundBias;
  return static_cast<int32_t>(upper_a + lower_b) - zero < t ||
         t < zero - static_cast<int32_t>(lower_a + upper_b);
}
constexpr bool boxes_apart(const PackedBox& a, const PackedBox& b, int32_t x, int32_t y,
                           int32_t z) {
  return apart_along(low_half(a.upper_xy), low_half(a.lower_xy), low_half(b.upper_xy),
                     low_half(b.lower_xy), x) ||
         apart_along(high_half(a.upper_xy), high_half(a.lower_xy), high_half(b.upper_xy),
                     high_half(b.lower_xy), y) ||
         apart_along(low_half(a.z), high_half(a.z), low_half(b.z), high_half(b.z), z);
}

/// Tests boxes of A against boxes of B moved by a translation. 12 bytes; made once a query.
class TranslatedOverlap {
 public:
  /// `x, y, z`: the translation of B in cells; any 32-bit value.
  constexpr TranslatedOverlap() : least_{} {}
  constexpr TranslatedOverlap(int32_t x, int32_t y, int32_t z)
      : least_{{join_halves(threshold(x), threshold(y)),
                join_halves(threshold_negated(x), threshold_negated(y)),
                join_halves(threshold(z), threshold_negated(z))}} {}

  /// True if the closed boxes share a point.
  bool operator()(const PackedBox& a, const PackedBox& b) const {
    return halves_reach(sums(a, b), least_);
  }

  /// The same by the reference form of the arithmetic.
  constexpr bool portable(const PackedBox& a, const PackedBox& b) const {
    return halves_reach_portable(sums(a, b), least_);
  }

 private:
  static constexpr PackedTriple sums(const PackedBox& a, const PackedBox& b) {
    return {{a.upper_xy + b.lower_xy, a.lower_xy + b.upper_xy, a.z + swap_halves(b.z)}};
  }

  /// Sums are 2 to 65,534: a threshold of 0 always holds, one of 65,535 never does.
  static constexpr uint32_t threshold(int32_t t) {
    const int32_t zero = 2 * kBoundBias;
    return t < -zero ? 0u : t >= zero ? 0xFFFFu : static_cast<uint32_t>(t + zero);
  }
  static constexpr uint32_t threshold_negated(int32_t t) {
    return threshold(t == INT32_MIN ? INT32_MAX : -t);
  }

  PackedTriple least_;
};

}  // namespace flashbvh

#endif
