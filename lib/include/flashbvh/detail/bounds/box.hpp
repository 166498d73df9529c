// The test whether two boxes overlap.
//
// Box A overlaps box B translated by t if on each axis
//     upper(A) - lower(B) >= t    and    upper(B) - lower(A) >= -t,
// that is, if six sums of two packed bounds reach six thresholds that depend on the translation
// alone. No form of the arithmetic wraps or saturates.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/arch/packed.hpp"
#include "flashbvh/detail/bounds/box_dsp.hpp"
#include "flashbvh/detail/bounds/box_simd.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"

namespace flashbvh::detail {

/// True if two boxes, the second one translated, are disjoint; for a single test, where making the
/// thresholds of TranslatedBoxTest would not pay. `along(axis)`: the translation in cells, within
/// +-3 * 2^29: a pose's and both origins. It is not called for axes after the first gap.
template <class Along>
FLASHBVH_INLINE constexpr bool boxes_disjoint(const PackedBox& a, const PackedBox& b,
                                              const Along& along) {
  constexpr int32_t zero = 2 * kBoundBias;  // the sum of two equal bounds
  const auto below = [](uint32_t sum, int32_t least) { return static_cast<int32_t>(sum) < least; };
  const uint32_t upper_xy = a.upper_xy + b.lower_xy;
  const int32_t x = along(0);
  if (below(low_half(upper_xy), zero + x)) {
    return true;
  }
  const uint32_t lower_xy = a.lower_xy + b.upper_xy;
  if (below(low_half(lower_xy), zero - x)) {
    return true;
  }
  const int32_t y = along(1);
  if (below(high_half(upper_xy), zero + y) || below(high_half(lower_xy), zero - y)) {
    return true;
  }
  const int32_t z = along(2);
  const uint32_t both_z = a.z + swap_halves(b.z);
  return below(low_half(both_z), zero + z) || below(high_half(both_z), zero - z);
}

/// Tests boxes of A against boxes of B under a translation. 12 bytes; made once per query.
class TranslatedBoxTest {
 public:
  /// Must be assigned to before it is called.
  TranslatedBoxTest() = default;
  /// `x, y, z`: the translation of B in cells, within +-3 * 2^29.
  TranslatedBoxTest(int32_t x, int32_t y, int32_t z)
      : least_{{join_halves(threshold(x), threshold(y)), join_halves(threshold(-x), threshold(-y)),
                join_halves(threshold(z), threshold(-z))}} {}

  /// True if the closed boxes share a point.
  FLASHBVH_INLINE bool operator()(const PackedBox& a, const PackedBox& b) const {
#if defined(FLASHBVH_BOX_SIMD)
    return bounds_reach_simd(a, b, least_);
#elif defined(FLASHBVH_BOX_DSP)
    return bounds_reach_dsp(a, b, least_);
#elif defined(__ARM_FEATURE_SIMD32) || defined(FLASHBVH_PORTABLE)
    return halves_reach(sums(a, b), least_);
#else  // word by word, so that an early rejection spares the other words' loads
    return word_reaches_plain(a.upper_xy + b.lower_xy, least_.word[0]) &&
           word_reaches_plain(a.lower_xy + b.upper_xy, least_.word[1]) &&
           word_reaches_plain(a.z + swap_halves(b.z), least_.word[2]);
#endif
  }

  /// Lower limits for a box's packed words: a box of B that reaches all of them overlaps `a`.
  /// window_of_b(): for boxes of A and `b`.
  PackedTriple window_of_a(const PackedBox& a) const {
    return window(least_, a);
  }
  PackedTriple window_of_b(const PackedBox& b) const {
    return window({{least_.word[1], least_.word[0], swap_halves(least_.word[2])}}, b);
  }

  /// operator() by the reference form of the arithmetic.
  constexpr bool portable(const PackedBox& a, const PackedBox& b) const {
    return halves_reach_portable(sums(a, b), least_);
  }

 private:
  static constexpr PackedTriple sums(const PackedBox& a, const PackedBox& b) {
    return {{a.upper_xy + b.lower_xy, a.lower_xy + b.upper_xy, a.z + swap_halves(b.z)}};
  }

  /// Sums are 2 to 65,534: a threshold of 0 always holds, one of 65,535 never does.
  static uint32_t threshold(int32_t t) {
    constexpr int32_t never = UINT16_MAX;
    const int32_t least = kZero + t;
    return static_cast<uint32_t>(least < 0 ? 0 : least > never ? never : least);
  }
  static constexpr int32_t kZero = 2 * kBoundBias;

  PackedTriple least_;
};

}  // namespace flashbvh::detail
