// Gaps of boxes with SSE2, one axis per lane: the arithmetic of gap.hpp, bit for bit. The fourth
// lane holds no bound, and is masked out before lanes are added.
#pragma once

#include <emmintrin.h>

#include "flashbvh/detail/lattice/box_packed.hpp"

namespace flashbvh::detail {

/// Biased bounds, upper and negated lower.
struct BoxTestLanes {
  __m128i upper;
  __m128i lower;
};

inline BoxTestLanes bound_lanes(const PackedBox& box) {
  const __m128i zero = _mm_setzero_si128();
  const __m128i xy =
      _mm_unpacklo_epi16(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(&box)), zero);
  const __m128i z = _mm_unpacklo_epi16(_mm_cvtsi32_si128(static_cast<int>(box.z)), zero);
  return {_mm_unpacklo_epi64(xy, z),
          _mm_unpackhi_epi64(xy, _mm_shuffle_epi32(z, _MM_SHUFFLE(3, 1, 1, 0)))};
}

/// The sum of squared gaps. A gap is `zero` less the smaller sum of its axis in `upper` or `lower`,
/// shifted right by `shift` and clamped to `most`, below 2^16.
inline uint32_t squared_gap_lanes(__m128i upper, __m128i lower, int32_t zero, uint32_t shift,
                                  uint32_t most) {
  const __m128i all_zero = _mm_set1_epi32(zero);
  const __m128i count = _mm_cvtsi32_si128(static_cast<int>(shift));
  // Less 2^15, so that signed halves saturate only for gaps below 0 or beyond `most`.
  const auto half_of = [&](__m128i sums) {
    return _mm_sub_epi32(_mm_sra_epi32(_mm_sub_epi32(all_zero, sums), count),
                         _mm_set1_epi32(1 << 15));
  };
  const __m128i both = _mm_packs_epi32(half_of(upper), half_of(lower));
  const __m128i larger = _mm_max_epi16(both, _mm_unpackhi_epi64(both, both));
  const __m128i cut = _mm_min_epi16(
      larger, _mm_set1_epi16(static_cast<int16_t>(static_cast<int32_t>(most) - (1 << 15))));
  const __m128i gap = _mm_and_si128(_mm_xor_si128(cut, _mm_set1_epi16(INT16_MIN)),
                                    _mm_set_epi32(0, 0, UINT16_MAX, -1));
  const __m128i squares = _mm_unpacklo_epi16(_mm_mullo_epi16(gap, gap), _mm_mulhi_epu16(gap, gap));
  const __m128i two = _mm_add_epi32(squares, _mm_unpackhi_epi64(squares, squares));
  const __m128i sum = _mm_add_epi32(two, _mm_shuffle_epi32(two, _MM_SHUFFLE(1, 1, 1, 1)));
  return static_cast<uint32_t>(_mm_cvtsi128_si32(sum));
}

/// Loads three words.
inline __m128i word_lanes(const uint32_t& first) {
  const uint32_t* const words = &first;
  return _mm_unpacklo_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(words)),
                            _mm_cvtsi32_si128(static_cast<int>(words[2])));
}

/// Sums of the bounds of two boxes, as in box.hpp.
inline __m128i sum_lanes(const PackedBox& a, const PackedBox& b) {
  const __m128i lanes = word_lanes(b.upper_xy);
  const __m128i swapped =
      _mm_shufflehi_epi16(_mm_shufflelo_epi16(lanes, _MM_SHUFFLE(1, 0, 3, 2)), 1);
  return _mm_add_epi16(word_lanes(a.upper_xy), swapped);
}

/// True if the gaps, by which halves miss `least`, are within a squared limit, which is below 2^30.
/// At most one of an axis's two bounds is missed.
inline bool is_within_lanes(__m128i least, __m128i halves, uint32_t limit) {
  const __m128i missing = _mm_subs_epu16(least, halves);
  if ((_mm_movemask_epi8(missing) & 0xAAAA) != 0) {
    return false;
  }
  const __m128i squares = _mm_madd_epi16(missing, missing);
  const __m128i two = _mm_add_epi32(squares, _mm_unpackhi_epi64(squares, squares));
  const __m128i sum = _mm_add_epi32(two, _mm_shuffle_epi32(two, _MM_SHUFFLE(1, 1, 1, 1)));
  return static_cast<uint32_t>(_mm_cvtsi128_si32(sum)) <= limit;
}

}  // namespace flashbvh::detail
