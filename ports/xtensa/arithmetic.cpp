// Integer functions that GCC calls and that its library for the LX106 omits.
#include <stdint.h>

namespace {

/// Returns the quotient; leaves the remainder in `dividend`. Computes one bit per iteration.
template <class Unsigned>
Unsigned divide(Unsigned& dividend, Unsigned divisor) {
  Unsigned quotient = 0;
  if (divisor == 0) {
    return 0;  // as on Arm cores
  }
  uint32_t shift = 0;
  while ((dividend >> shift) / 2 >= divisor) {
    ++shift;
  }
  for (++shift; shift-- != 0;) {
    if (dividend >> shift >= divisor) {
      dividend -= divisor << shift;
      quotient |= Unsigned{1} << shift;
    }
  }
  return quotient;
}

template <class Unsigned, class Signed>
Unsigned magnitude(Signed value) {
  const auto bits = static_cast<Unsigned>(value);
  return value < 0 ? Unsigned{0} - bits : bits;
}

template <class Unsigned, class Signed>
Signed signed_quotient(Signed dividend, Signed divisor) {
  Unsigned left = magnitude<Unsigned>(dividend);
  const Unsigned quotient = divide(left, magnitude<Unsigned>(divisor));
  return static_cast<Signed>((dividend < 0) != (divisor < 0) ? Unsigned{0} - quotient : quotient);
}

template <class Unsigned, class Signed>
Signed signed_remainder(Signed dividend, Signed divisor) {
  Unsigned left = magnitude<Unsigned>(dividend);
  divide(left, magnitude<Unsigned>(divisor));
  return static_cast<Signed>(dividend < 0 ? Unsigned{0} - left : left);
}

/// Product of two 32-bit numbers, from products of 16 bits.
uint64_t product(uint32_t a, uint32_t b) {
  const uint32_t low = (a & 0xFFFFu) * (b & 0xFFFFu);
  const uint32_t one = (a >> 16) * (b & 0xFFFFu) + (low >> 16);
  const uint32_t other = (a & 0xFFFFu) * (b >> 16) + (one & 0xFFFFu);
  const uint32_t high = (a >> 16) * (b >> 16) + (one >> 16) + (other >> 16);
  return uint64_t{high} << 32 | (other << 16 | (low & 0xFFFFu));
}

}  // namespace

extern "C" {
int64_t __muldi3(int64_t a, int64_t b) {
  const auto x = static_cast<uint64_t>(a);
  const auto y = static_cast<uint64_t>(b);
  const uint32_t cross = static_cast<uint32_t>(x >> 32) * static_cast<uint32_t>(y) +
                         static_cast<uint32_t>(x) * static_cast<uint32_t>(y >> 32);
  return static_cast<int64_t>(product(static_cast<uint32_t>(x), static_cast<uint32_t>(y)) +
                              (uint64_t{cross} << 32));
}
uint64_t __umulsidi3(uint32_t a, uint32_t b) {
  return product(a, b);
}
uint32_t __udivsi3(uint32_t a, uint32_t b) {
  return divide(a, b);
}
uint32_t __umodsi3(uint32_t a, uint32_t b) {
  divide(a, b);
  return a;
}
int32_t __divsi3(int32_t a, int32_t b) {
  return signed_quotient<uint32_t>(a, b);
}
int32_t __modsi3(int32_t a, int32_t b) {
  return signed_remainder<uint32_t>(a, b);
}
uint64_t __udivdi3(uint64_t a, uint64_t b) {
  return divide(a, b);
}
uint64_t __umoddi3(uint64_t a, uint64_t b) {
  divide(a, b);
  return a;
}
int64_t __divdi3(int64_t a, int64_t b) {
  return signed_quotient<uint64_t>(a, b);
}
int64_t __moddi3(int64_t a, int64_t b) {
  return signed_remainder<uint64_t>(a, b);
}
}
