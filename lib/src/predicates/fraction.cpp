// 128-bit arithmetic, and 256-bit comparison of fractions that are nearly equal.
#include "flashbvh/detail/predicates/fraction.hpp"

#include "long_division.hpp"
#include "wide_product.hpp"

#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {
namespace {

/// Word i of a number, counted from the lowest; no core is big-endian (plain/byte_order.h).
inline uint32_t word_of(const Int128& u, int i) {
  uint32_t word = 0;
  const char* const at =
      reinterpret_cast<const char*>(&u) + sizeof word * static_cast<unsigned>(i ^ 2);
  __builtin_memcpy(&word, __builtin_assume_aligned(at, alignof(uint32_t)), sizeof word);
  return word;
}

/// Sign of u v - w x for numbers that are not negative. Computed by columns of 32 bits, so that no
/// product is stored.
[[gnu::noinline]] int compare_products(const Int128& u, const Int128& v, const Int128& w,
                                       const Int128& x) {
  constexpr int kWords = 4;
  int64_t sum = 0;
  int64_t above = 0;
  uint32_t any = 0;
  int column = 0;
  int i = 0;
  for (int left = kWords * kWords; left != 0; --left) {
    const uint64_t one = uint64_t{word_of(u, i)} * word_of(v, column - i);
    const uint64_t other = uint64_t{word_of(w, i)} * word_of(x, column - i);
    sum += static_cast<int64_t>(one & kLowHalf) - static_cast<int64_t>(other & kLowHalf);
    above += static_cast<int64_t>(one >> 32) - static_cast<int64_t>(other >> 32);
    if (i != column && i != kWords - 1) {
      ++i;
      continue;
    }
    any |= static_cast<uint32_t>(sum);
    sum = (sum >> 32) + above;
    above = 0;
    ++column;
    i = column < kWords ? 0 : column - kWords + 1;
  }
  any |= static_cast<uint32_t>(sum);  // the last column has the carry alone
  return sum >> 32 < 0 ? -1 : any != 0 ? 1 : 0;
}

/// Leading bits of a number above 0: it is at least digits * 2^exponent and below (digits + 1) *
/// 2^exponent. Digits have 31 bits, the first of them 1.
struct Leading {
  [[gnu::noinline]] explicit Leading(const Int128& u) {
    const bool by_word = u.high != 0;
    const uint64_t word = by_word ? static_cast<uint64_t>(u.high) : u.low;
    const int zeros = __builtin_clzll(word);
    const uint64_t below = by_word ? u.low : 0;
    const uint64_t top = word << zeros | below >> 1 >> (63 - zeros);
    digits = static_cast<uint32_t>(top >> 33);
    exponent = (by_word ? 97 : 33) - zeros;
  }
  uint32_t digits;
  int32_t exponent;
};

/// compare(), or 2 if the leading bits do not decide.
[[gnu::noinline]] int compare_leading(const Fraction& x, const Fraction& y) {
  if (is_zero(x.above) || is_zero(y.above)) {
    return sign_of(x.above) - sign_of(y.above);
  }
  const Leading x_above(x.above);
  const Leading x_below(x.below);
  const Leading y_above(y.above);
  const Leading y_below(y.below);
  // x_above * y_below against y_above * x_below: products of digits are from 2^60 to 2^62.
  const int32_t shift = x_above.exponent + y_below.exponent - y_above.exponent - x_below.exponent;
  const int32_t size = shift < 0 ? -shift : shift;
  if (size > 2) {
    return shift < 0 ? -1 : 1;
  }
  const auto least = [](const Leading& u, const Leading& v) {
    return static_cast<uint64_t>(u.digits) * v.digits;
  };
  const auto most = [](const Leading& u, const Leading& v) {
    return (static_cast<uint64_t>(u.digits) + 1) * (static_cast<uint64_t>(v.digits) + 1);
  };
  // Products are divided by 4, so that the larger one fits after the shift.
  const int32_t x_up = shift > 0 ? shift : 0;
  const int32_t y_up = shift < 0 ? -shift : 0;
  if (((most(x_above, y_below) >> 2) + 1) << x_up <= (least(y_above, x_below) >> 2) << y_up) {
    return -1;
  }
  if (((most(y_above, x_below) >> 2) + 1) << y_up <= (least(x_above, y_below) >> 2) << x_up) {
    return 1;
  }
  return 2;
}

}  // namespace

Int128 full_product(int64_t u, int64_t v) noexcept {
  const auto p = static_cast<uint64_t>(u);
  const auto q = static_cast<uint64_t>(v);
  Int128 wide = unsigned_product(p, q);
  const uint64_t more = (u < 0 ? q : 0) + (v < 0 ? p : 0);
  wide.high = static_cast<int64_t>(static_cast<uint64_t>(wide.high) - more);
  return wide;
}

Int128 times(const Int128& u, int32_t v) noexcept {
  Int128 wide = unsigned_product(u.low, static_cast<uint64_t>(v < 0 ? -int64_t{v} : v));
  const uint64_t high =
      static_cast<uint64_t>(u.high) * static_cast<uint64_t>(v < 0 ? -int64_t{v} : v);
  wide.high = static_cast<int64_t>(static_cast<uint64_t>(wide.high) + high);
  return v < 0 ? -wide : wide;
}

Int128 shifted_up(const Int128& u, unsigned bits) noexcept {
  if (bits >= 64) {
    return {static_cast<int64_t>(u.low << (bits - 64)), 0};
  }
  if (bits == 0) {
    return u;
  }
  return {static_cast<int64_t>(static_cast<uint64_t>(u.high) << bits | u.low >> (64 - bits)),
          // `low` is unsigned, so the shift is defined.
          // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult)
          u.low << bits};
}

Int128 quotient(const Int128& u, const Int128& v) noexcept {
#if defined(FLASHBVH_HAS_INT128)
  const auto native = [](const Int128& x) {
    return Native{static_cast<uint64_t>(x.high)} << 64 | x.low;
  };
  return of_native(native(u) / native(v));
#else
  return long_quotient(u, v);
#endif
}

uint64_t square_root(const Int128& u) noexcept {
  uint64_t root = 0;
  for (uint64_t bit = uint64_t{1} << (u.high != 0 ? 63 : 31); bit != 0; bit >>= 1) {
    const Int128 square = unsigned_product(root | bit, root | bit);
    if (square.high >= 0 && !(u < square)) {
      root |= bit;
    }
  }
  return root;
}

uint32_t square_root(uint64_t u) noexcept {
  uint32_t root = 0;
  for (uint32_t bit = 1u << 31; bit != 0; bit >>= 1) {
    const uint32_t more = root | bit;
    root = static_cast<uint64_t>(more) * more <= u ? more : root;
  }
  return root;
}

int compare(const Fraction& x, const Fraction& y) noexcept {
  // Neighbours share edges, so equal fractions are frequent.
  if (x.above == y.above && x.below == y.below) {
    return 0;
  }
  const int order = compare_leading(x, y);
  return order != 2 ? order : compare_products(x.above, y.below, y.above, x.below);
}

bool is_above(const Fraction& x, const ShortFraction& y) noexcept {
  Int128 limit = unsigned_product(x.below.low, y.above);
  const uint64_t more = static_cast<uint64_t>(x.below.high) * y.above;
  limit.high = static_cast<int64_t>(static_cast<uint64_t>(limit.high) + more);
  Int128 value = unsigned_product(x.above.low, y.below);
  const uint64_t rest = static_cast<uint64_t>(x.above.high) * y.below;
  value.high = static_cast<int64_t>(static_cast<uint64_t>(value.high) + rest);
  return limit < value;
}

int64_t rounded_up(const Fraction& x) noexcept {
  if (is_zero(x.above)) {
    return 0;
  }
  const Leading above(x.above);
  const Leading below(x.below);
  // The quotient of digits, at most 2, with 31 fraction bits, one bit per step.
  uint32_t rest = above.digits + 1;
  uint64_t share = 0;
  for (int bit = 31; bit >= 0; --bit) {
    const bool fits = rest >= below.digits;
    rest = (fits ? rest - below.digits : rest) << 1;
    share = share << 1 | (fits ? 1 : 0);
  }
  ++share;
  const int32_t down = 31 - (above.exponent - below.exponent);
  return static_cast<int64_t>(down <= 0 ? share << -down : down > 40 ? 1 : (share >> down) + 1);
}

}  // namespace flashbvh::detail
