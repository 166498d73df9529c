// 128-bit quotients for machines that cannot divide such numbers, and roots by quotients.
#pragma once

#include "flashbvh/detail/predicates/fraction.hpp"
#include "short_root.hpp"
#include "wide_product.hpp"

namespace flashbvh::detail {

/// quotient(), 29 bits or more per step. A step divides the rest's leading bits by those of `v`
/// plus 1, so it never subtracts too much.
inline Int128 long_quotient(const Int128& u, const Int128& v) {
  const auto bits = [](const Int128& x) {
    return x.high != 0 ? 128 - __builtin_clzll(static_cast<uint64_t>(x.high))
                       : 64 - __builtin_clzll(x.low | 1);
  };
  const auto leading = [](const Int128& x, int down) {
    return down < 0     ? x.low << -down
           : down == 0  ? x.low
           : down >= 64 ? static_cast<uint64_t>(x.high) >> (down - 64)
                        : static_cast<uint64_t>(x.high) << 1 << (63 - down) | x.low >> down;
  };
  const int down = bits(v) - 31;
  const uint64_t divisor = leading(v, down) + 1;
  Int128 whole = {0, 0};
  Int128 rest = u;
  while (!(rest < v)) {
    const int rest_down = bits(rest) - 63;
    const uint64_t share = leading(rest, rest_down) / divisor;
    const int up = rest_down - down;
    Int128 part = {0, up < 0 ? share >> -up : share};
    part = up > 0 ? shifted_up(part, static_cast<unsigned>(up)) : part;
    // `v` fits once more, which the leading bits are too few to show.
    part.low += is_zero(part) ? 1u : 0u;
    rest = rest - low_product(part, v);
    whole = whole + part;
  }
  return whole;
}

/// square_root() in fewer steps, with more stack.
inline uint64_t long_root(const Int128& u) {
  // Converges from above: the leading bits' root has 15 bits or more, and each Newton step doubles
  // them.
  const int bits = u.high != 0 ? 128 - __builtin_clzll(static_cast<uint64_t>(u.high))
                               : 64 - __builtin_clzll(u.low | 1);
  const int down = bits > 32 ? (bits - 31) & ~1 : 0;
  const auto top = static_cast<uint32_t>(
      down >= 64  ? static_cast<uint64_t>(u.high) >> (down - 64)
      : down == 0 ? u.low
                  : static_cast<uint64_t>(u.high) << (64 - down) | u.low >> down);
  uint64_t root = uint64_t{short_root(top)} << (down / 2);
  if (down == 0) {
    return root;
  }
  root += uint64_t{1} << (down / 2);
  for (int step = bits > 64 ? 2 : 1; step != 0; --step) {
    root = (root >> 1) + (quotient(u, {0, root}).low >> 1) + 2;
  }
  for (;; --root) {
    const Int128 square = unsigned_product(root, root);
    if (square.high >= 0 && !(u < square)) {
      return root;
    }
  }
}

}  // namespace flashbvh::detail
