// The inner step of the rotated box test with SSE2: all three axes at once, two products a lane
// (PMADDWD). The arithmetic is that of box_rotated.cpp, bit for bit: halves are below 2^15, and no
// sum leaves 32 bits.
#ifndef FLASHBVH_BOX_ROTATED_SSE2_HPP
#define FLASHBVH_BOX_ROTATED_SSE2_HPP

#include <emmintrin.h>
#include <string.h>

#include "flashbvh/detail/box_rotated.hpp"

namespace flashbvh::detail {

/// A matrix with its columns in vectors: lane i is row i.
struct SplitVectors {
  __m128i positive_xy;
  __m128i negative_xy;
  __m128i z;
};

inline SplitVectors transposed(const SplitMatrix& matrix) {
  const auto row = [&matrix](int i) {
    const SplitRow& r = matrix.row[i];
    return _mm_set_epi32(0, static_cast<int>(r.z), static_cast<int>(r.negative_xy),
                         static_cast<int>(r.positive_xy));
  };
  const __m128i xy01 = _mm_unpacklo_epi32(row(0), row(1));
  const __m128i z01 = _mm_unpackhi_epi32(row(0), row(1));
  const __m128i xy2 = _mm_unpacklo_epi32(row(2), _mm_setzero_si128());
  const __m128i z2 = _mm_unpackhi_epi32(row(2), _mm_setzero_si128());
  return {_mm_unpacklo_epi64(xy01, xy2), _mm_unpackhi_epi64(xy01, xy2),
          _mm_unpacklo_epi64(z01, z2)};
}

/// The bounds of `box` rotated by `matrix`, its sums beginning at `starts`.
inline PackedBox rotated_sse2(const SplitMatrix& matrix, const BoundStart* starts,
                              const PackedBox& box) {
  const SplitVectors m = transposed(matrix);
  const auto all = [](uint32_t word) { return _mm_set1_epi32(static_cast<int>(word)); };
  const __m128i box_upper = all(box.upper_xy);
  const __m128i box_lower = all(box.lower_xy);
  const auto sum = [&m](__m128i start, __m128i positive, __m128i negative, __m128i z) {
    const __m128i xy = _mm_add_epi32(_mm_madd_epi16(m.positive_xy, positive),
                                     _mm_madd_epi16(m.negative_xy, negative));
    return _mm_srai_epi32(_mm_add_epi32(_mm_add_epi32(start, xy), _mm_madd_epi16(m.z, z)),
                          kSplitBits);
  };
  const __m128i upper = sum(_mm_set_epi32(0, starts[2].upper, starts[1].upper, starts[0].upper),
                            box_upper, box_lower, all(box.z));
  const __m128i lower = sum(_mm_set_epi32(0, starts[2].lower, starts[1].lower, starts[0].lower),
                            box_lower, box_upper, all(swap_halves(box.z)));
  // Whole cells from 0 to 32,767, four upper bounds and four lower ones.
  const __m128i cells = _mm_max_epi16(_mm_packs_epi32(upper, lower), _mm_setzero_si128());
  uint32_t words[4];
  memcpy(words, &cells, sizeof words);
  return {words[0], words[2], join_halves(low_half(words[1]), low_half(words[3]))};
}

}  // namespace flashbvh::detail

#endif
