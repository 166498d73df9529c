// Start values of a rotated box's sums, and the test whether B as a whole is apart from A, with
// SSE2. One axis per lane, and one branch; equals rotated_transform.cpp bit for bit.
#pragma once

#include "gap.hpp"
#include "sums.hpp"

namespace flashbvh::detail {

/// start_of() for all axes.
inline BoxTestLanes start_all(const RowLanes& rows, const int32_t (&offset)[3], int32_t margin) {
  constexpr int bias_bits = 14;
  static_assert(kBoundBias == 1 << bias_bits);
  const __m128i ones = _mm_set1_epi16(1);
  const __m128i magnitudes =
      _mm_add_epi32(_mm_madd_epi16(_mm_add_epi16(rows.positive_xy, rows.negative_xy), ones),
                    _mm_madd_epi16(rows.z, ones));
  const __m128i bias =
      _mm_slli_epi32(_mm_sub_epi32(_mm_set1_epi32(kSplitOne), magnitudes), bias_bits);
  const __m128i shared = _mm_add_epi32(bias, _mm_set1_epi32(margin));
  const __m128i offsets = _mm_set_epi32(0, offset[2], offset[1], offset[0]);
  return {_mm_add_epi32(shared, offsets), _mm_sub_epi32(shared, offsets)};
}

inline void store_all(const BoxTestLanes& from, BoxTestStart (&starts)[3]) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(&starts[0]),
                   _mm_unpacklo_epi32(from.upper, from.lower));
  _mm_storel_epi64(reinterpret_cast<__m128i*>(&starts[2]),
                   _mm_unpackhi_epi32(from.upper, from.lower));
}

/// Returns whether B's root box, rotated, is apart from A's along one of A's axes.
inline bool far_apart(const RowLanes& rows, const BoxTestLanes& starts, const PackedBox& root_a,
                      const PackedBox& root_b) {
  const BoxTestLanes sums = rotated_lanes(rows, starts, root_b);
  return compare(root_a, box_of_sums(sums.upper, sums.lower)) != 0;
}

}  // namespace flashbvh::detail
