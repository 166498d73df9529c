// Numbers of 128 bits and fractions of them, for exact comparisons of distances.
//
// Portable C++: 32-bit cores have no integer of 128 bits. Numbers are in two's complement. Nothing
// is checked: callers keep the ranges.
#pragma once

#include <stdint.h>

namespace flashbvh::detail {

struct Int128 {
  int64_t high;
  uint64_t low;
};

constexpr Int128 widened(int64_t value) {
  return {value < 0 ? -1 : 0, static_cast<uint64_t>(value)};
}

constexpr Int128 operator+(const Int128& u, const Int128& v) {
  const uint64_t low = u.low + v.low;
  const uint64_t carry = low < u.low ? 1 : 0;
  return {
      static_cast<int64_t>(static_cast<uint64_t>(u.high) + static_cast<uint64_t>(v.high) + carry),
      low};
}
constexpr Int128 operator-(const Int128& u) {
  return {static_cast<int64_t>(~static_cast<uint64_t>(u.high) + (u.low == 0 ? 1 : 0)), ~u.low + 1};
}
constexpr Int128 operator-(const Int128& u, const Int128& v) {
  return u + -v;
}

constexpr bool operator<(const Int128& u, const Int128& v) {
  return u.high != v.high ? u.high < v.high : u.low < v.low;
}
constexpr bool operator==(const Int128& u, const Int128& v) {
  return u.high == v.high && u.low == v.low;
}
constexpr bool is_zero(const Int128& u) {
  return (static_cast<uint64_t>(u.high) | u.low) == 0;
}
/// -1, 0 or 1.
constexpr int sign_of(const Int128& u) {
  return u.high < 0 ? -1 : is_zero(u) ? 0 : 1;
}
constexpr int sign_of(int64_t u) {
  return u < 0 ? -1 : u == 0 ? 0 : 1;
}

/// The exact product.
Int128 full_product(int64_t u, int64_t v) noexcept;
/// `u` within +-2^95.
Int128 times(const Int128& u, int32_t v) noexcept;
/// `bits`: up to 127; bits shifted out at the top are lost.
Int128 shifted_up(const Int128& u, unsigned bits) noexcept;
/// The quotient, rounded down: `u` not negative, `v` positive. A core without 128-bit division
/// takes a step for each 29 bits of it.
Int128 quotient(const Int128& u, const Int128& v) noexcept;
/// The largest number whose square is not above `u`, which is not negative.
uint64_t square_root(const Int128& u) noexcept;
/// The square root of 64 bits, rounded down; works bit by bit.
uint32_t square_root(uint64_t u) noexcept;

/// Not negative; `below` is positive.
struct Fraction {
  Int128 above;
  Int128 below;
};

/// Above all squared distances.
inline constexpr Fraction kInfinite = {{INT64_MAX, 0}, {0, 1}};

/// -1, 0 or 1 as x is below, equal to or above y. Exact; nearly always the leading bits decide.
int compare(const Fraction& x, const Fraction& y) noexcept;

/// A fraction for comparisons in 128 bits. With fractions of parts below 2^108 and 2^72, it has
/// parts below 2^46 and 2^17. With those of meshes, below 2^108 and 2^64, `above` is below 2^57.
struct ShortFraction {
  uint64_t above;
  uint32_t below;
};
/// True if x is above y; exact.
bool is_above(const Fraction& x, const ShortFraction& y) noexcept;

/// A whole number that is not below `x`, and above it by at most 1 and one part in 2^29. `x`: below
/// 2^43.
int64_t rounded_up(const Fraction& x) noexcept;

}  // namespace flashbvh::detail
