// The inner step of the rotated box test with SSE2: three axes at once, two products per lane
// (PMADDWD). Results equal those of portable/rotate_box.hpp, bit for bit: halves are below 2^15,
// and no sum leaves 32 bits.
#pragma once

#include <emmintrin.h>
#include <string.h>

#include "flashbvh/detail/bounds/box_rotated.hpp"

namespace flashbvh::detail {

/// Packs sums, which have kSplitBits fraction bits, into a box. Whole cells are clamped to 0 to
/// 32,767, beyond which no box lies.
inline PackedBox box_of_sums(__m128i upper, __m128i lower) {
  upper = _mm_srai_epi32(upper, kSplitBits);
  lower = _mm_srai_epi32(lower, kSplitBits);
  const __m128i cells = _mm_max_epi16(_mm_packs_epi32(upper, lower), _mm_setzero_si128());
  uint32_t words[4];
  memcpy(words, &cells, sizeof words);
  return {words[0], words[2], join_halves(low_half(words[1]), low_half(words[3]))};
}

/// The bounds of a rotated box.
inline PackedBox rotated_sse2(const BoxRotation& by, const PackedBox& box) {
  const auto lanes = [](const auto& words) {
    return _mm_load_si128(reinterpret_cast<const __m128i*>(words));
  };
  const auto all = [](uint32_t word) { return _mm_set1_epi32(static_cast<int>(word)); };
  const __m128i box_upper = all(box.upper_xy);
  const __m128i box_lower = all(box.lower_xy);
  const auto sum = [&](const int32_t* start, __m128i positive, __m128i negative, __m128i z) {
    const __m128i xy = _mm_add_epi32(_mm_madd_epi16(lanes(by.positive_xy), positive),
                                     _mm_madd_epi16(lanes(by.negative_xy), negative));
    return _mm_add_epi32(_mm_add_epi32(lanes(start), xy), _mm_madd_epi16(lanes(by.z), z));
  };
  return box_of_sums(sum(by.upper, box_upper, box_lower, all(box.z)),
                     sum(by.lower, box_lower, box_upper, all(swap_halves(box.z))));
}

}  // namespace flashbvh::detail
