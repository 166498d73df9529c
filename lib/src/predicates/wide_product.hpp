// 128-bit products, native if the compiler has 128-bit integers.
#pragma once

#include "flashbvh/detail/predicates/fraction.hpp"

namespace flashbvh::detail {

inline constexpr uint64_t kLowHalf = UINT32_MAX;

#if defined(__SIZEOF_INT128__) && !defined(FLASHBVH_PORTABLE)
#define FLASHBVH_HAS_INT128 1

// For machines that multiply 64 bits; results equal those of the portable form.
__extension__ using Native = unsigned __int128;

inline Int128 of_native(Native value) {
  return {static_cast<int64_t>(value >> 64), static_cast<uint64_t>(value)};
}

inline Int128 unsigned_product(uint64_t u, uint64_t v) {
  return of_native(Native{u} * v);
}

#else

inline Int128 unsigned_product(uint64_t u, uint64_t v) {
  const uint64_t low = (u & kLowHalf) * (v & kLowHalf);
  const uint64_t first = (u >> 32) * (v & kLowHalf) + (low >> 32);
  const uint64_t second = (u & kLowHalf) * (v >> 32) + (first & kLowHalf);
  return {static_cast<int64_t>((u >> 32) * (v >> 32) + (first >> 32) + (second >> 32)),
          (second << 32) | (low & kLowHalf)};
}

#endif

/// The low 128 bits of the product.
inline Int128 low_product(const Int128& u, const Int128& v) {
  Int128 product = unsigned_product(u.low, v.low);
  product.high = static_cast<int64_t>(static_cast<uint64_t>(product.high) +
                                      u.low * static_cast<uint64_t>(v.high) +
                                      static_cast<uint64_t>(u.high) * v.low);
  return product;
}

}  // namespace flashbvh::detail
