// Where the sums of a rotated box begin, and whether all of B is far from A, with SSE2: an axis a
// lane, with the arithmetic of rotated_transform.cpp, bit for bit, and one branch for all three.
#ifndef FLASHBVH_STARTS_SSE2_HPP
#define FLASHBVH_STARTS_SSE2_HPP

#include <emmintrin.h>

#include "flashbvh/detail/rotated_transform.hpp"

namespace flashbvh::detail {

/// The rows of a rotation, an axis a lane; what is in the fourth means nothing.
struct RowLanes {
  __m128i positive_xy;
  __m128i negative_xy;
  __m128i z;

  explicit RowLanes(const RotationMatrix& matrix) {
    // Four words where a row has three: the last row's are followed by the rest.
    static_assert(sizeof(RotationMatrix) >= sizeof(SplitMatrix) + sizeof(uint32_t));
    const auto* const words = reinterpret_cast<const char*>(&matrix.rows);
    const auto load = [&](size_t row) {
      return _mm_loadu_si128(reinterpret_cast<const __m128i*>(words + row * sizeof(SplitRow)));
    };
    const __m128i last = load(2);
    const __m128i xy = _mm_unpacklo_epi32(load(0), load(1));
    positive_xy = _mm_unpacklo_epi64(xy, last);
    negative_xy = _mm_unpackhi_epi64(xy, _mm_slli_si128(last, 4));
    z = _mm_unpacklo_epi64(_mm_unpackhi_epi32(load(0), load(1)), _mm_srli_si128(last, 8));
  }

  /// Of each row's magnitudes.
  __m128i sums() const {
    const __m128i ones = _mm_set1_epi16(1);
    return _mm_add_epi32(_mm_madd_epi16(_mm_add_epi16(positive_xy, negative_xy), ones),
                         _mm_madd_epi16(z, ones));
  }
  __m128i bound(__m128i start, uint32_t positive, uint32_t negative, uint32_t by_z) const {
    const auto all = [](uint32_t word) { return _mm_set1_epi32(static_cast<int>(word)); };
    const __m128i xy = _mm_add_epi32(_mm_madd_epi16(positive_xy, all(positive)),
                                     _mm_madd_epi16(negative_xy, all(negative)));
    const __m128i sum = _mm_add_epi32(_mm_add_epi32(start, xy), _mm_madd_epi16(z, all(by_z)));
    return _mm_srai_epi32(sum, kSplitBits);
  }
};

/// start_of() for all axes, an axis a lane.
struct StartLanes {
  __m128i upper;
  __m128i lower;

  StartLanes(const RowLanes& rows, const int32_t (&offset)[3], int32_t margin) {
    constexpr int bias_bits = 14;
    static_assert(kBoundBias == 1 << bias_bits);
    const __m128i one = _mm_set1_epi32(kSplitOne);
    const __m128i bias = _mm_slli_epi32(_mm_sub_epi32(one, rows.sums()), bias_bits);
    const __m128i shared = _mm_add_epi32(bias, _mm_set1_epi32(margin));
    const __m128i offsets = _mm_set_epi32(0, offset[2], offset[1], offset[0]);
    upper = _mm_add_epi32(shared, offsets);
    lower = _mm_sub_epi32(shared, offsets);
  }

  void store(BoundStart (&starts)[3]) const {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(&starts[0]), _mm_unpacklo_epi32(upper, lower));
    _mm_storel_epi64(reinterpret_cast<__m128i*>(&starts[2]), _mm_unpackhi_epi32(upper, lower));
  }
};

/// Whether along one of the axes all of B is beyond A's root box.
inline bool far_apart(const RowLanes& rows, const StartLanes& starts, const PackedBox& root_a,
                      const PackedBox& root_b) {
  const __m128i most = rows.bound(starts.upper, root_b.upper_xy, root_b.lower_xy, root_b.z);
  const __m128i least =
      rows.bound(starts.lower, root_b.lower_xy, root_b.upper_xy, swap_halves(root_b.z));
  // Whole cells from 0 to 32,767: what is beyond is as far from any box.
  const __m128i cells = _mm_max_epi16(_mm_packs_epi32(most, least), _mm_setzero_si128());
  const auto words = [](__m128i two) { return static_cast<uint64_t>(_mm_cvtsi128_si64(two)); };
  const uint64_t upper = words(cells);
  const uint64_t lower = words(_mm_unpackhi_epi64(cells, cells));
  const PackedBox b = {static_cast<uint32_t>(upper), static_cast<uint32_t>(lower),
                       join_halves(low_half(static_cast<uint32_t>(upper >> 32)),
                                   static_cast<uint32_t>(lower >> 32))};
  return compare(root_a, b) != 0;
}

}  // namespace flashbvh::detail

#endif
