// Sums of products of 15-bit numbers, of which a word holds two.
//
// Plain C++ is the definition; where the core has the DSP extension (Cortex-M4, M7, M33, M55) one
// instruction does it (SMLAD, SMLADX). No form wraps where the true sum fits in 32 bits.
// FLASHBVH_PORTABLE selects the definition everywhere.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/packed.hpp"

namespace flashbvh::detail {

#if defined(__ARM_FEATURE_DSP) && !defined(FLASHBVH_PORTABLE)

/// sum + low * low + high * high. Halves are 0 to 32,767.
inline int32_t add_products(int32_t sum, uint32_t u, uint32_t v) {
  return __smlad(static_cast<int16x2_t>(u), static_cast<int16x2_t>(v), sum);
}
/// sum + low * high + high * low. Halves are 0 to 32,767.
inline int32_t add_crossed_products(int32_t sum, uint32_t u, uint32_t v) {
  return __smladx(static_cast<int16x2_t>(u), static_cast<int16x2_t>(v), sum);
}
/// add_products() for signed halves.
inline int32_t add_signed_products(int32_t sum, uint32_t u, uint32_t v) {
  return add_products(sum, u, v);
}
/// low * high - high * low, of signed halves.
inline int32_t cross_halves(uint32_t u, uint32_t v) {
  return __smusdx(static_cast<int16x2_t>(u), static_cast<int16x2_t>(v));
}
/// The sum of the squares of four halves: each is at most 32,767, and one of `v`'s is 0.
inline uint32_t sum_of_squares(uint32_t u, uint32_t v) {
  const auto of_u = static_cast<int16x2_t>(u);
  const auto of_v = static_cast<int16x2_t>(v);
  return static_cast<uint32_t>(__smlad(of_v, of_v, __smuad(of_u, of_u)));
}
/// u - v, half by half, signed.
inline uint32_t signed_difference(uint32_t u, uint32_t v) {
  return static_cast<uint32_t>(__ssub16(static_cast<int16x2_t>(u), static_cast<int16x2_t>(v)));
}
/// (u - v) / 2, half by half, signed; rounded down.
inline uint32_t halved_difference(uint32_t u, uint32_t v) {
  return static_cast<uint32_t>(__shsub16(static_cast<int16x2_t>(u), static_cast<int16x2_t>(v)));
}
/// Signed halves of 15 bits, with negative ones replaced by 0.
inline uint32_t positive_halves(uint32_t u) {
  return static_cast<uint32_t>(__builtin_arm_usat16(static_cast<int16x2_t>(u), 15));
}

#else

constexpr int32_t signed_low(uint32_t u) {
  return static_cast<int16_t>(low_half(u));
}
constexpr int32_t signed_high(uint32_t u) {
  return static_cast<int16_t>(high_half(u));
}
/// add_products() for signed halves.
constexpr int32_t add_signed_products(int32_t sum, uint32_t u, uint32_t v) {
  return sum + signed_low(u) * signed_low(v) + signed_high(u) * signed_high(v);
}
/// low * high - high * low, of signed halves.
constexpr int32_t cross_halves(uint32_t u, uint32_t v) {
  return signed_low(u) * signed_high(v) - signed_high(u) * signed_low(v);
}
/// u - v, half by half, signed.
constexpr uint32_t signed_difference(uint32_t u, uint32_t v) {
  return join_halves((u - v) & 0xFFFFu, (u >> 16) - (v >> 16));
}
/// (u - v) / 2, half by half, signed; rounded down.
constexpr uint32_t halved_difference(uint32_t u, uint32_t v) {
  const auto half = [](int32_t x, int32_t y) { return static_cast<uint16_t>((x - y) >> 1); };
  return join_halves(half(signed_low(u), signed_low(v)), half(signed_high(u), signed_high(v)));
}
/// Signed halves of 15 bits, with negative ones replaced by 0.
constexpr uint32_t positive_halves(uint32_t u) {
  return u & ~(((u >> 15) & 0x00010001u) * 0xFFFFu);
}

/// sum + low * low + high * high. Halves are 0 to 32,767.
constexpr int32_t add_products(int32_t sum, uint32_t u, uint32_t v) {
  return sum + static_cast<int32_t>(low_half(u) * low_half(v)) +
         static_cast<int32_t>(high_half(u) * high_half(v));
}
/// sum + low * high + high * low. Halves are 0 to 32,767.
constexpr int32_t add_crossed_products(int32_t sum, uint32_t u, uint32_t v) {
  return sum + static_cast<int32_t>(low_half(u) * high_half(v)) +
         static_cast<int32_t>(high_half(u) * low_half(v));
}

#endif

}  // namespace flashbvh::detail
