// Sine and cosine of a part of a turn, in fixed point, bit-identical on every core.
#pragma once

#include <stdint.h>

namespace flashbvh::detail {

/// Both within 2^-29 of the exact values.
struct SineCosine {
  int32_t sine;  ///< kRotationOne is 1
  int32_t cosine;
};

/// The upper half of the product, rounded down.
inline int32_t times_high(int32_t u, int32_t v) {
  return static_cast<int32_t>((static_cast<int64_t>(u) * v) >> 32);
}

/// `turn`: in 2^-32 of a turn. Some 70 instructions on a Cortex-M4.
///
/// Polynomials through the Chebyshev nodes, in the square of an angle up to an eighth of a turn,
/// x = pi/4 y. sin x = y S(y^2) to 4 * 2^-40 and cos x = C(y^2) to 2^-34; with rounded coefficients
/// to 2^-30.7 and 2^-33.3. The first coefficient has 30 fraction bits, each next one 2 more, since
/// the square has 30 and a product drops 32.
inline SineCosine sine_cosine(uint32_t turn) {
  constexpr int32_t s[5] = {843314857, -346799333, 42784630, -2513236, 84936};
  constexpr int32_t c[5] = {1073741824, -1324675869, 272375233, -22398329, 970263};
  const uint32_t quarter = (turn + (1u << 29)) >> 30;                  // the nearest, 4 for none
  const auto y = static_cast<int32_t>((turn - (quarter << 30)) << 2);  // 31 fraction bits
  const int32_t square = times_high(y, y);
  int32_t sine = s[4];
  int32_t cosine = c[4];
  for (int i = 3; i > 0; --i) {
    sine = s[i] + times_high(sine, square);
    cosine = c[i] + times_high(cosine, square);
  }
  constexpr int64_t half = int64_t{1} << 31;
  sine = s[0] + static_cast<int32_t>((static_cast<int64_t>(sine) * square + half) >> 32);
  cosine = c[0] + static_cast<int32_t>((static_cast<int64_t>(cosine) * square + half) >> 32);
  sine = static_cast<int32_t>((static_cast<int64_t>(sine) * y + (half >> 1)) >> 31);
  const bool is_odd = (quarter & 1) != 0;
  const int32_t u = is_odd ? cosine : sine;
  const int32_t v = is_odd ? -sine : cosine;
  return (quarter & 2) != 0 ? SineCosine{-u, -v} : SineCosine{u, v};
}

}  // namespace flashbvh::detail
