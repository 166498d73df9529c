// The test whether two boxes overlap.
//
// Box A overlaps box B moved by t if on each axis
//     upper(A) - lower(B) >= t    and    upper(B) - lower(A) >= -t,
// that is, if six sums of two packed bounds reach six thresholds that depend on the translation
// alone. No form of the arithmetic wraps or saturates.
#ifndef FLASHBVH_BOX_HPP
#define FLASHBVH_BOX_HPP

#include <stdint.h>

#include "flashbvh/box_packed.hpp"
#include "flashbvh/box_simd.hpp"
#include "flashbvh/packed.hpp"

namespace flashbvh {

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
  /// To be assigned to before it is asked.
  TranslatedOverlap() = default;
  /// `x, y, z`: the translation of B in cells; any 32-bit value.
  constexpr TranslatedOverlap(int32_t x, int32_t y, int32_t z)
      : least_{{join_halves(threshold(x), threshold(y)),
                join_halves(threshold_negated(x), threshold_negated(y)),
                join_halves(threshold(z), threshold_negated(z))}} {}

  /// True if the closed boxes share a point.
  bool operator()(const PackedBox& a, const PackedBox& b) const {
#if defined(FLASHBVH_BOX_SIMD)
    return bounds_reach_simd(a, b, least_);
#elif defined(__ARM_FEATURE_SIMD32) || defined(FLASHBVH_PORTABLE)
    return halves_reach(sums(a, b), least_);
#else  // word by word, so that what an early rejection does not need is not even loaded
    return word_reaches_plain(a.upper_xy + b.lower_xy, least_.word[0]) &&
           word_reaches_plain(a.lower_xy + b.upper_xy, least_.word[1]) &&
           word_reaches_plain(a.z + swap_halves(b.z), least_.word[2]);
#endif
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
