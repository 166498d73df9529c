// The quotient of numbers of 128 bits where no machine divides them.
#ifndef FLASHBVH_PREDICATES_LONG_DIVISION_HPP
#define FLASHBVH_PREDICATES_LONG_DIVISION_HPP

#include "flashbvh/detail/predicates/fraction.hpp"

namespace flashbvh::detail {

/// As quotient(): bit by bit, from the quotient's leading one, or the one below it, on.
inline Int128 long_quotient(const Int128& u, const Int128& v) {
  Int128 whole = {0, 0};
  if (u < v) {
    return whole;
  }
  const auto zeros = [](const Int128& x) {
    return x.high != 0 ? __builtin_clzll(static_cast<uint64_t>(x.high))
                       : 64 + __builtin_clzll(x.low);
  };
  int bit = zeros(v) - zeros(u);
  Int128 rest = u;
  Int128 divisor = shifted_up(v, static_cast<unsigned>(bit));
  for (; bit >= 0; --bit) {
    whole = whole + whole;
    if (!(rest < divisor)) {
      rest = rest - divisor;
      whole.low |= 1;
    }
    const auto high = static_cast<uint64_t>(divisor.high);
    divisor = {static_cast<int64_t>(high >> 1), high << 63 | divisor.low >> 1};
  }
  return whole;
}

}  // namespace flashbvh::detail

#endif
