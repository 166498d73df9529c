// Multiplying numbers that lie two in a word, and adding up.
//
// Plain C++ is the definition; where the core has the DSP extension (Cortex-M4, M7, M33, M55) one
// instruction does it (SMLAD, SMLADX). No form wraps where the true sum fits in 32 bits.
// FLASHBVH_PORTABLE selects the definition everywhere.
#ifndef FLASHBVH_DETAIL_PACKED_MULTIPLY_HPP
#define FLASHBVH_DETAIL_PACKED_MULTIPLY_HPP

#include <stdint.h>

#include "flashbvh/detail/packed.hpp"

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
/// As add_products(), of halves with a sign; here alone.
inline int32_t add_signed_products(int32_t sum, uint32_t u, uint32_t v) {
  return add_products(sum, u, v);
}
/// Half by half u - v, with a sign; here alone.
inline uint32_t signed_difference(uint32_t u, uint32_t v) {
  return static_cast<uint32_t>(__ssub16(static_cast<int16x2_t>(u), static_cast<int16x2_t>(v)));
}

#else

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

#endif
