// The overlap test with the vector instructions that desktop compilers assume: SSE2 and NEON. It
// makes all six sums at once and one branch, as branches cost most on a core that predicts them.
//
// Bit-identical to the forms in packed.hpp: the fourth word is zero and so is its threshold.
#pragma once

#include "flashbvh/detail/arch/packed.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"

#if defined(FLASHBVH_PORTABLE)
// The reference everywhere.
#elif defined(__SSE2__)
#define FLASHBVH_BOX_SIMD 1
#include <emmintrin.h>
#elif defined(__ARM_NEON) && defined(__ARM_ARCH) && __ARM_ARCH >= 7
#define FLASHBVH_BOX_SIMD 1
#include <arm_neon.h>
#endif

namespace flashbvh::detail {

#if defined(FLASHBVH_BOX_SIMD) && defined(__SSE2__)

/// True if the six sums of bounds of `a` and `b` reach `least`.
inline bool bounds_reach_simd(const PackedBox& a, const PackedBox& b, const PackedTriple& least) {
  const auto first_two = [](const void* words) {
    return _mm_loadl_epi64(static_cast<const __m128i*>(words));
  };
  const auto third = [](uint32_t word) { return _mm_cvtsi32_si128(static_cast<int>(word)); };
  const __m128i xy = _mm_add_epi16(first_two(&a), _mm_shuffle_epi32(first_two(&b), 0xE1));
  const __m128i z = _mm_add_epi16(third(a.z), third(swap_halves(b.z)));
  const __m128i threshold = _mm_unpacklo_epi64(first_two(&least), third(least.word[2]));
  const __m128i missing = _mm_subs_epu16(threshold, _mm_unpacklo_epi64(xy, z));
  return _mm_movemask_epi8(_mm_cmpeq_epi16(missing, _mm_setzero_si128())) == 0xFFFF;
}

#elif defined(FLASHBVH_BOX_SIMD)

/// True if the six sums of bounds of `a` and `b` reach `least`.
inline bool bounds_reach_simd(const PackedBox& a, const PackedBox& b, const PackedTriple& least) {
  const auto first_two = [](const void* words) {
    return vld1_u32(static_cast<const uint32_t*>(words));
  };
  const auto third = [](uint32_t word) { return vset_lane_u32(word, vdup_n_u32(0), 0); };
  const auto add = [](uint32x2_t u, uint32x2_t v) {
    return vadd_u16(vreinterpret_u16_u32(u), vreinterpret_u16_u32(v));
  };
  const uint16x4_t xy = add(first_two(&a), vrev64_u32(first_two(&b)));
  const uint16x4_t z = add(third(a.z), third(swap_halves(b.z)));
  const uint16x4_t missing_xy = vqsub_u16(vreinterpret_u16_u32(first_two(&least)), xy);
  const uint16x4_t missing_z = vqsub_u16(vreinterpret_u16_u32(third(least.word[2])), z);
  return vget_lane_u64(vreinterpret_u64_u16(vorr_u16(missing_xy, missing_z)), 0) == 0;
}

#endif

}  // namespace flashbvh::detail
