// Multiplying signed 16-bit numbers that lie two in a word, and adding up.
//
// Plain C++ is the definition; where the core has the DSP extension (Cortex-M4, M7, M33, M55) its
// one-instruction forms (SMLAD, SMLABB, SMLAWB and their kin) are used. No form wraps or saturates
// in the ranges stated by the callers. FLASHBVH_PORTABLE selects the definition everywhere.
#ifndef FLASHBVH_PACKED_MULTIPLY_HPP
#define FLASHBVH_PACKED_MULTIPLY_HPP

#include <stdint.h>

#include "flashbvh/packed.hpp"

namespace flashbvh {

constexpr int32_t signed_low(uint32_t word) {
  return static_cast<int16_t>(word & 0xFFFFu);
}
constexpr int32_t signed_high(uint32_t word) {
  return static_cast<int16_t>(word >> 16);
}
/// Two numbers from -32,768 to 32,767 in a word.
constexpr uint32_t join_signed(int32_t low, int32_t high) {
  return (static_cast<uint32_t>(low) & 0xFFFFu) | (static_cast<uint32_t>(high) << 16);
}

#if defined(__ARM_FEATURE_DSP) && !defined(FLASHBVH_PORTABLE)

/// low * low + high * high.
inline int32_t multiply_pairs(uint32_t u, uint32_t v) {
  return __smuad(static_cast<int16x2_t>(u), static_cast<int16x2_t>(v));
}
/// sum + the named half of u * the named half of v.
inline int32_t add_low_low(int32_t sum, uint32_t u, uint32_t v) {
  return __smlabb(static_cast<int32_t>(u), static_cast<int32_t>(v), sum);
}
inline int32_t add_low_high(int32_t sum, uint32_t u, uint32_t v) {
  return __smlabt(static_cast<int32_t>(u), static_cast<int32_t>(v), sum);
}
inline int32_t add_high_low(int32_t sum, uint32_t u, uint32_t v) {
  return __smlatb(static_cast<int32_t>(u), static_cast<int32_t>(v), sum);
}
inline int32_t add_high_high(int32_t sum, uint32_t u, uint32_t v) {
  return __smlatt(static_cast<int32_t>(u), static_cast<int32_t>(v), sum);
}
/// sum + (wide * half of v) / 65,536, rounded down.
inline int32_t add_wide_low(int32_t sum, int32_t wide, uint32_t v) {
  return __smlawb(wide, static_cast<int32_t>(v), sum);
}
inline int32_t add_wide_high(int32_t sum, int32_t wide, uint32_t v) {
  return __smlawt(wide, static_cast<int32_t>(v), sum);
}

#else

/// low * low + high * high.
inline int32_t multiply_pairs(uint32_t u, uint32_t v) {
  return signed_low(u) * signed_low(v) + signed_high(u) * signed_high(v);
}
/// sum + the named half of u * the named half of v.
inline int32_t add_low_low(int32_t sum, uint32_t u, uint32_t v) {
  return sum + signed_low(u) * signed_low(v);
}
inline int32_t add_low_high(int32_t sum, uint32_t u, uint32_t v) {
  return sum + signed_low(u) * signed_high(v);
}
inline int32_t add_high_low(int32_t sum, uint32_t u, uint32_t v) {
  return sum + signed_high(u) * signed_low(v);
}
inline int32_t add_high_high(int32_t sum, uint32_t u, uint32_t v) {
  return sum + signed_high(u) * signed_high(v);
}
/// wide * half / 65,536, rounded down, in 32-bit products alone, since the smallest cores have no
/// others.
inline int32_t multiply_wide(int32_t wide, int32_t half) {
  const int32_t low = static_cast<int32_t>(static_cast<uint32_t>(wide) & 0xFFFFu);
  return (wide >> 16) * half + ((low * half) >> 16);
}
/// sum + (wide * half of v) / 65,536, rounded down.
inline int32_t add_wide_low(int32_t sum, int32_t wide, uint32_t v) {
  return sum + multiply_wide(wide, signed_low(v));
}
inline int32_t add_wide_high(int32_t sum, int32_t wide, uint32_t v) {
  return sum + multiply_wide(wide, signed_high(v));
}

#endif

}  // namespace flashbvh

#endif
