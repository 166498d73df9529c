// Tests two slabs at once, with the vector instructions that desktop compilers assume: all four
// sums in one vector, and one branch. Bit-identical to Slab::may_touch(): no sum leaves 32 bits.
#pragma once

#include "flashbvh/detail/bounds/slab.hpp"

#if defined(__SSE2__) && !defined(FLASHBVH_PORTABLE)
#include <emmintrin.h>
#endif

namespace flashbvh::detail {

/// False only if the box has no point in one of the slabs.
FLASHBVH_INLINE inline bool may_touch_both(const Slab& first, const Slab& second,
                                           const PackedBox& box) {
#if defined(__SSE2__) && !defined(FLASHBVH_PORTABLE)
  const auto all = [](uint32_t word) { return _mm_set1_epi32(static_cast<int>(word)); };
  const auto pair = [](uint32_t low, uint32_t high) {
    return _mm_unpacklo_epi32(_mm_cvtsi32_si128(static_cast<int>(low)),
                              _mm_cvtsi32_si128(static_cast<int>(high)));
  };
  const SplitRow& u = first.row();
  const SplitRow& v = second.row();
  // For the upper bound along each row, and for the negated lower one.
  const __m128i xy =
      _mm_unpacklo_epi64(pair(u.positive_xy, u.negative_xy), pair(v.positive_xy, v.negative_xy));
  const __m128i exchanged_xy = _mm_shuffle_epi32(xy, 0xB1);
  const __m128i zs = pair(u.z, v.z);
  const __m128i z = _mm_unpacklo_epi32(zs, _mm_shufflelo_epi16(zs, 0xB1));
  const __m128i sums = _mm_add_epi32(_mm_add_epi32(_mm_madd_epi16(xy, all(box.upper_xy)),
                                                   _mm_madd_epi16(exchanged_xy, all(box.lower_xy))),
                                     _mm_madd_epi16(z, all(box.z)));
  const __m128i least = _mm_set_epi32(second.least_lower(), second.least_upper(),
                                      first.least_lower(), first.least_upper());
  return _mm_movemask_epi8(_mm_cmpgt_epi32(least, sums)) == 0;
#else
  return first.may_touch(box) && second.may_touch(box);
#endif
}

}  // namespace flashbvh::detail
