// Float and double functions that GCC calls and that its library for the LX106 omits. IEEE 754,
// rounded to the nearest, halves to even, with subnormals, infinities and NaN.
//
// Sums and products of floats are computed as doubles: these have more than twice the bits of
// floats, and 2 more, so rounding twice gives the nearest float (Figueroa 1995).
#include <stdint.h>

namespace {

/// Shifts right; the lowest bit of the result is 1 if any dropped bit was 1.
template <class Bits>
Bits shift_right(Bits value, int shift) {
  if (shift >= static_cast<int>(8 * sizeof(Bits))) {
    return value != 0;
  }
  return shift <= 0 ? value : value >> shift | ((value & ((Bits{1} << shift) - 1)) != 0);
}

/// A floating-point format, by its word and the bits of its fraction.
template <class BitsType, int kFractionBits>
struct Format {
  using Bits = BitsType;
  static constexpr int kFraction = kFractionBits;
  static constexpr int kWidth = static_cast<int>(8 * sizeof(Bits));
  static constexpr int kLargest = (1 << (kWidth - 1 - kFraction)) - 1;  // of infinity and NaN
  static constexpr int kBias = kLargest / 2;
  static constexpr Bits kSign = Bits{1} << (kWidth - 1);
  static constexpr Bits kHidden = Bits{1} << kFraction;
  static constexpr Bits kInfinity = Bits{kLargest} << kFraction;
  static constexpr Bits kNan = kInfinity | kHidden >> 1;
};
using Single = Format<uint32_t, 23>;
using Double = Format<uint64_t, 52>;

/// mantissa * 2^(exponent - bias - fraction)
template <class F>
struct Number {
  typename F::Bits sign;
  int exponent;
  typename F::Bits mantissa;

  explicit Number(typename F::Bits bits)
      : sign(bits & F::kSign),
        exponent(static_cast<int>((bits & ~F::kSign) >> F::kFraction)),
        mantissa(bits & (F::kHidden - 1)) {
    if (exponent != 0) {
      mantissa |= F::kHidden;
    } else {
      exponent = 1;
    }
  }
  bool is_special() const { return exponent == F::kLargest; }
  bool is_nan() const { return is_special() && mantissa != F::kHidden; }
  bool is_zero() const { return mantissa == 0; }
  void normalise() {
    for (; mantissa != 0 && mantissa < F::kHidden; --exponent) {
      mantissa <<= 1;
    }
  }
};

/// The number nearest to mantissa * 2^(exponent - bias - fraction - 3).
template <class F>
typename F::Bits pack(typename F::Bits sign, int exponent, typename F::Bits mantissa) {
  if (mantissa == 0) {
    return sign;
  }
  for (; mantissa >= F::kHidden << 4; ++exponent) {
    mantissa = shift_right(mantissa, 1);
  }
  for (; mantissa < F::kHidden << 3; --exponent) {
    mantissa <<= 1;
  }
  if (exponent >= F::kLargest) {
    return sign | F::kInfinity;
  }
  if (exponent <= 0) {
    mantissa = shift_right(mantissa, 1 - exponent);
    exponent = 1;  // subnormal: without the hidden bit
  }
  const auto rest = static_cast<uint32_t>(mantissa & 7u);
  typename F::Bits bits =
      (static_cast<typename F::Bits>(exponent - 1) << F::kFraction) + (mantissa >> 3);
  if (rest > 4 || (rest == 4 && (bits & 1) != 0)) {
    ++bits;
  }
  return sign | bits;
}

uint64_t add(uint64_t one, uint64_t other) {
  if ((one & ~Double::kSign) < (other & ~Double::kSign)) {
    const uint64_t less = one;
    one = other;
    other = less;
  }
  const Number<Double> a(one);
  const Number<Double> b(other);
  if (a.is_special()) {
    return a.is_nan() || (b.is_special() && a.sign != b.sign) ? Double::kNan : one;
  }
  const uint64_t moved = shift_right(b.mantissa << 3, a.exponent - b.exponent);
  if (a.sign == b.sign) {
    return pack<Double>(a.sign, a.exponent, (a.mantissa << 3) + moved);
  }
  const uint64_t rest = (a.mantissa << 3) - moved;
  return rest == 0 ? 0 : pack<Double>(a.sign, a.exponent, rest);
}

/// a * b * 2^-shift for numbers below 2^53; 32 < shift < 64.
uint64_t product(uint64_t a, uint64_t b, int shift) {
  const uint64_t low = (a & 0xFFFFFFFFu) * (b & 0xFFFFFFFFu);
  const uint64_t one = (a >> 32) * (b & 0xFFFFFFFFu) + (low >> 32);
  const uint64_t other = (a & 0xFFFFFFFFu) * (b >> 32) + (one & 0xFFFFFFFFu);
  const uint64_t high = (a >> 32) * (b >> 32) + (one >> 32) + (other >> 32);
  const uint64_t least = other << 32 | (low & 0xFFFFFFFFu);
  return high << (64 - shift) | shift_right(least, shift);
}

uint64_t multiply(uint64_t one, uint64_t other) {
  Number<Double> a(one);
  Number<Double> b(other);
  const uint64_t sign = a.sign ^ b.sign;
  if (a.is_special() || b.is_special()) {
    const bool is_nan = a.is_nan() || b.is_nan() || a.is_zero() || b.is_zero();
    return is_nan ? Double::kNan : sign | Double::kInfinity;
  }
  a.normalise();
  b.normalise();
  return pack<Double>(sign, a.exponent + b.exponent - Double::kBias,
                      product(a.mantissa, b.mantissa, Double::kFraction - 3));
}

uint64_t divide(uint64_t one, uint64_t other) {
  Number<Double> a(one);
  Number<Double> b(other);
  const uint64_t sign = a.sign ^ b.sign;
  if (a.is_nan() || b.is_nan() || (a.is_special() && b.is_special()) ||
      (a.is_zero() && b.is_zero())) {
    return Double::kNan;
  }
  if (a.is_special() || b.is_zero()) {
    return sign | Double::kInfinity;
  }
  if (b.is_special() || a.is_zero()) {
    return sign;
  }
  a.normalise();
  b.normalise();
  uint64_t quotient = 0;
  for (int i = 0; i < Double::kFraction + 4; ++i, a.mantissa <<= 1) {
    quotient <<= 1;
    if (a.mantissa >= b.mantissa) {
      a.mantissa -= b.mantissa;
      quotient |= 1;
    }
  }
  return pack<Double>(sign, a.exponent - b.exponent + Double::kBias,
                      quotient | static_cast<uint64_t>(a.mantissa != 0));
}

template <class To, class From>
To bits_of(From value) {
  static_assert(sizeof(To) == sizeof(From), "");
  To bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// Rounded towards 0; any number if it does not fit.
uint32_t truncated(double value) {
  const Number<Double> number(bits_of<uint64_t>(value));
  const int shift = Double::kBias + Double::kFraction - number.exponent;
  const auto magnitude =
      static_cast<uint32_t>(shift > 0 && shift < 64 ? number.mantissa >> shift : 0);
  return number.sign != 0 ? 0 - magnitude : magnitude;
}

double whole(uint32_t magnitude, uint64_t sign) {
  return bits_of<double>(pack<Double>(sign, Double::kBias + Double::kFraction + 3, magnitude));
}

double wide(float value) {
  const Number<Single> number(bits_of<uint32_t>(value));
  const uint64_t sign = uint64_t{number.sign} << 32;
  if (number.is_special()) {
    return bits_of<double>(sign | (number.is_nan() ? Double::kNan : Double::kInfinity));
  }
  constexpr int kUp = Double::kFraction - Single::kFraction;
  return bits_of<double>(pack<Double>(sign, number.exponent - Single::kBias + Double::kBias,
                                      uint64_t{number.mantissa} << (kUp + 3)));
}

float narrow(double value) {
  const Number<Double> number(bits_of<uint64_t>(value));
  const auto sign = static_cast<uint32_t>(number.sign >> 32);
  if (number.is_special()) {
    return bits_of<float>(sign | (number.is_nan() ? Single::kNan : Single::kInfinity));
  }
  constexpr int kDown = Double::kFraction - Single::kFraction - 3;
  return bits_of<float>(pack<Single>(sign, number.exponent - Double::kBias + Single::kBias,
                                     static_cast<uint32_t>(shift_right(number.mantissa, kDown))));
}

}  // namespace

extern "C" {
double __adddf3(double a, double b) {
  return bits_of<double>(add(bits_of<uint64_t>(a), bits_of<uint64_t>(b)));
}
double __subdf3(double a, double b) {
  return bits_of<double>(add(bits_of<uint64_t>(a), bits_of<uint64_t>(b) ^ Double::kSign));
}
double __muldf3(double a, double b) {
  return bits_of<double>(multiply(bits_of<uint64_t>(a), bits_of<uint64_t>(b)));
}
double __divdf3(double a, double b) {
  return bits_of<double>(divide(bits_of<uint64_t>(a), bits_of<uint64_t>(b)));
}
double __floatunsidf(uint32_t value) {
  return whole(value, 0);
}
double __floatsidf(int32_t value) {
  const auto bits = static_cast<uint32_t>(value);
  return value < 0 ? whole(0 - bits, Double::kSign) : whole(bits, 0);
}
int32_t __fixdfsi(double value) {
  return static_cast<int32_t>(truncated(value));
}
uint32_t __fixunsdfsi(double value) {
  return truncated(value);
}
double __extendsfdf2(float value) {
  return wide(value);
}
float __truncdfsf2(double value) {
  return narrow(value);
}
float __addsf3(float a, float b) {
  return narrow(__adddf3(wide(a), wide(b)));
}
float __subsf3(float a, float b) {
  return narrow(__subdf3(wide(a), wide(b)));
}
float __mulsf3(float a, float b) {
  return narrow(__muldf3(wide(a), wide(b)));
}
float __floatsisf(int32_t value) {
  return narrow(__floatsidf(value));
}
float __floatunsisf(uint32_t value) {
  return narrow(whole(value, 0));
}
uint32_t __fixunssfsi(float value) {
  return truncated(wide(value));
}
}
