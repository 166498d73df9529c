// Arithmetic with two 16-bit numbers in a 32-bit word.
//
// Comparisons have three forms, equal bit for bit: plain C++ as the reference, UQSUB16 with the DSP
// extension (Cortex-M4, M7, M33, M55), and two comparisons of words on cores without it (Cortex-M0,
// M3, RISC-V). FLASHBVH_PORTABLE selects the reference everywhere.
#pragma once

#include <stdint.h>

#include "flashbvh/plain/byte_order.h"

#if (defined(__ARM_FEATURE_SIMD32) || defined(__ARM_FEATURE_SAT)) && !defined(FLASHBVH_PORTABLE)
#include <arm_acle.h>
#endif

namespace flashbvh::detail {

constexpr uint32_t low_half(uint32_t word) {
  return word & 0xFFFFu;
}
constexpr uint32_t high_half(uint32_t word) {
  return word >> 16;
}
constexpr uint32_t join_halves(uint32_t low, uint32_t high) {
  return low | (high << 16);
}
constexpr uint32_t swap_halves(uint32_t word) {
  return (word << 16) | (word >> 16);
}

/// Clamps `value` to 0 and 2^kBits - 1: one instruction (USAT) on cores that have it. Compilers do
/// not always find it.
template <unsigned kBits>
inline uint32_t saturated(int32_t value) {
#if defined(__ARM_FEATURE_SAT) && !defined(FLASHBVH_PORTABLE)
  return __usat(value, kBits);
#else
  constexpr int32_t most = INT32_MAX >> (31 - kBits);
  return static_cast<uint32_t>(value < 0 ? 0 : value > most ? most : value);
#endif
}

/// Three pairs of unsigned 16-bit numbers.
struct PackedTriple {
  uint32_t word[3];
};

/// True if each half of `value` is at least the same half of `least`; the reference.
constexpr bool halves_reach_portable(const PackedTriple& value, const PackedTriple& least) {
  for (int i = 0; i < 3; ++i) {
    if (low_half(value.word[i]) < low_half(least.word[i]) ||
        high_half(value.word[i]) < high_half(least.word[i])) {
      return false;
    }
  }
  return true;
}

/// True if both halves of `value` reach those of `least`. If the low halves do, comparing whole
/// words decides about the high halves.
constexpr bool word_reaches_plain(uint32_t value, uint32_t least) {
  return value >= least && (value << 16) >= (least << 16);
}
constexpr bool halves_reach_plain(const PackedTriple& value, const PackedTriple& least) {
  return word_reaches_plain(value.word[0], least.word[0]) &&
         word_reaches_plain(value.word[1], least.word[1]) &&
         word_reaches_plain(value.word[2], least.word[2]);
}

#if defined(__ARM_FEATURE_SIMD32) && !defined(FLASHBVH_PORTABLE)
/// halves_reach() by saturating subtraction: a half of `least - value` is 0 if `value` reaches it.
inline bool halves_reach_dsp(const PackedTriple& value, const PackedTriple& least) {
  return (__uqsub16(least.word[0], value.word[0]) | __uqsub16(least.word[1], value.word[1]) |
          __uqsub16(least.word[2], value.word[2])) == 0;
}
#endif

/// u - v, half by half, with 0 in place of negative differences.
inline uint32_t subtract_halves(uint32_t u, uint32_t v) {
#if defined(__ARM_FEATURE_SIMD32) && !defined(FLASHBVH_PORTABLE)
  return __uqsub16(u, v);
#else
  const auto half = [](uint32_t x, uint32_t y) { return x > y ? x - y : 0; };
  return join_halves(half(low_half(u), low_half(v)), half(high_half(u), high_half(v)));
#endif
}

/// This core's fastest form of halves_reach_portable().
inline bool halves_reach(const PackedTriple& value, const PackedTriple& least) {
#if defined(FLASHBVH_PORTABLE)
  return halves_reach_portable(value, least);
#elif defined(__ARM_FEATURE_SIMD32)
  return halves_reach_dsp(value, least);
#else
  return halves_reach_plain(value, least);
#endif
}

}  // namespace flashbvh::detail
