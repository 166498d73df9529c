// Rotates a box into the other lattice with SSE2: three axes at once, two products per lane
// (PMADDWD), as in sums.hpp. Results equal those of gap.cpp, bit for bit.
#pragma once

#include <emmintrin.h>

#include "flashbvh/detail/bounds/gap.hpp"

namespace flashbvh::detail {

/// Words of a matrix's rows, one axis per lane; the fourth lane is unused.
struct RowLanes {
  __m128i positive_xy;
  __m128i negative_xy;
  __m128i z;
};

inline RowLanes row_lanes(const SplitMatrix& matrix) {
  const auto lanes = [&matrix](uint32_t SplitRow::*word) {
    const auto of = [&](int i) { return static_cast<int>(matrix.row[i].*word); };
    return _mm_set_epi32(0, of(2), of(1), of(0));
  };
  return {lanes(&SplitRow::positive_xy), lanes(&SplitRow::negative_xy), lanes(&SplitRow::z)};
}

inline BoxTestLanes start_lanes(const BoxTestStart* starts) {
  static_assert(sizeof(BoxTestStart) == 2 * sizeof(int32_t), "words without gaps");
  const __m128i two =
      _mm_shuffle_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(starts)), 0xD8);
  const __m128i third = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(starts + 2));
  return {_mm_unpacklo_epi64(two, third), _mm_unpackhi_epi64(two, _mm_shuffle_epi32(third, 0x50))};
}

/// Bounds of a rotated box, with kSplitBits fraction bits.
inline BoxTestLanes rotated_lanes(const RowLanes& rows, const BoxTestLanes& start,
                                  const PackedBox& box) {
  const auto all = [](uint32_t word) { return _mm_set1_epi32(static_cast<int>(word)); };
  const __m128i box_upper = all(box.upper_xy);
  const __m128i box_lower = all(box.lower_xy);
  const auto sum = [&](__m128i from, __m128i positive, __m128i negative, __m128i z) {
    const __m128i xy = _mm_add_epi32(_mm_madd_epi16(rows.positive_xy, positive),
                                     _mm_madd_epi16(rows.negative_xy, negative));
    return _mm_add_epi32(from, _mm_add_epi32(xy, _mm_madd_epi16(rows.z, z)));
  };
  return {sum(start.upper, box_upper, box_lower, all(box.z)),
          sum(start.lower, box_lower, box_upper, all(swap_halves(box.z)))};
}

/// As rotate() in gap.cpp.
inline void rotate_lanes(const SplitMatrix& matrix, const BoxTestStart* starts, int32_t rounding,
                         const PackedBox& box, SeenBox& seen) {
  const BoxTestLanes sums = rotated_lanes(row_lanes(matrix), start_lanes(starts), box);
  const auto set = [rounding](int32_t(&bounds)[4], __m128i sum) {
    _mm_store_si128(reinterpret_cast<__m128i*>(bounds),
                    _mm_srai_epi32(_mm_add_epi32(sum, _mm_set1_epi32(rounding)), kSplitBits));
  };
  set(seen.upper, sums.upper);
  set(seen.lower, sums.lower);
}

/// Lower limits for a box's packed words: whole cells of `zero` less a sum, saturated to 16 bits.
inline PackedTriple window_lanes(const BoxTestLanes& sums, int32_t zero) {
  const __m128i half = _mm_set1_epi32(1 << 15);  // so that a signed half saturates
  const auto cells = [&](__m128i sum) {
    return _mm_sub_epi32(_mm_srai_epi32(_mm_sub_epi32(_mm_set1_epi32(zero), sum), kSplitBits),
                         half);
  };
  const __m128i both = _mm_xor_si128(_mm_packs_epi32(cells(sums.lower), cells(sums.upper)),
                                     _mm_set1_epi16(INT16_MIN));
  const auto word = [](__m128i lanes) { return static_cast<uint32_t>(_mm_cvtsi128_si32(lanes)); };
  return {{word(both), word(_mm_unpackhi_epi64(both, both)),
           join_halves(static_cast<uint32_t>(_mm_extract_epi16(both, 2)),
                       static_cast<uint32_t>(_mm_extract_epi16(both, 6)))}};
}

}  // namespace flashbvh::detail
