// Float and double functions that GCC calls and that its library for the LX106 omits. IEEE 754,
// rounded to the nearest, halves to even, with subnormals, infinities and NaN.
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

template <class F>
typename F::Bits add(typename F::Bits one, typename F::Bits other) {
  if ((one & ~F::kSign) < (other & ~F::kSign)) {
    const typename F::Bits less = one;
    one = other;
    other = less;
  }
  const Number<F> a(one);
  const Number<F> b(other);
  if (a.is_special()) {
    return a.is_nan() || (b.is_special() && a.sign != b.sign) ? F::kNan : one;
  }
  const typename F::Bits moved =
      shift_right<typename F::Bits>(b.mantissa << 3, a.exponent - b.exponent);
  if (a.sign == b.sign) {
    return pack<F>(a.sign, a.exponent, (a.mantissa << 3) + moved);
  }
  const typename F::Bits rest = (a.mantissa << 3) - moved;
  return rest == 0 ? 0 : pack<F>(a.sign, a.exponent, rest);
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

template <class F>
typename F::Bits multiply(typename F::Bits one, typename F::Bits other) {
  Number<F> a(one);
  Number<F> b(other);
  const typename F::Bits sign = a.sign ^ b.sign;
  if (a.is_special() || b.is_special()) {
    const bool is_nan = a.is_nan() || b.is_nan() || a.is_zero() || b.is_zero();
    return is_nan ? F::kNan : sign | F::kInfinity;
  }
  a.normalise();
  b.normalise();
  constexpr int kUp = Double::kFraction - F::kFraction;  // of a, so that all formats share a shift
  const uint64_t mantissa = product(uint64_t{a.mantissa} << kUp, b.mantissa, Double::kFraction - 3);
  return pack<F>(sign, a.exponent + b.exponent - F::kBias, static_cast<typename F::Bits>(mantissa));
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

/// Converts a whole number.
template <class F>
typename F::Bits whole(uint32_t magnitude, bool is_negative) {
  return pack<F>(is_negative ? F::kSign : 0, F::kBias + F::kFraction + 3, magnitude);
}

template <class F>
uint32_t truncated(typename F::Bits bits) {
  const Number<F> number(bits);
  const int shift = number.exponent - F::kBias - F::kFraction;
  const typename F::Bits magnitude = shift >= 0
                                         ? number.mantissa << (shift < 31 ? shift : 31)
                                         : (shift > -F::kWidth ? number.mantissa >> -shift : 0);
  return static_cast<uint32_t>(number.sign != 0 ? 0 - magnitude : magnitude);
}

template <class To, class From>
To bits_of(From value) {
  static_assert(sizeof(To) == sizeof(From), "");
  To bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}

float single(uint32_t bits) {
  return bits_of<float>(bits);
}
double dual(uint64_t bits) {
  return bits_of<double>(bits);
}
uint32_t bits(float value) {
  return bits_of<uint32_t>(value);
}
uint64_t bits(double value) {
  return bits_of<uint64_t>(value);
}

}  // namespace

extern "C" {
float __addsf3(float a, float b) {
  return single(add<Single>(bits(a), bits(b)));
}
float __subsf3(float a, float b) {
  return single(add<Single>(bits(a), bits(b) ^ Single::kSign));
}
float __mulsf3(float a, float b) {
  return single(multiply<Single>(bits(a), bits(b)));
}
double __adddf3(double a, double b) {
  return dual(add<Double>(bits(a), bits(b)));
}
double __subdf3(double a, double b) {
  return dual(add<Double>(bits(a), bits(b) ^ Double::kSign));
}
double __muldf3(double a, double b) {
  return dual(multiply<Double>(bits(a), bits(b)));
}
double __divdf3(double a, double b) {
  return dual(divide(bits(a), bits(b)));
}
float __floatsisf(int32_t value) {
  return single(whole<Single>(
      value < 0 ? 0u - static_cast<uint32_t>(value) : static_cast<uint32_t>(value), value < 0));
}
float __floatunsisf(uint32_t value) {
  return single(whole<Single>(value, false));
}
double __floatsidf(int32_t value) {
  return dual(whole<Double>(
      value < 0 ? 0u - static_cast<uint32_t>(value) : static_cast<uint32_t>(value), value < 0));
}
double __floatunsidf(uint32_t value) {
  return dual(whole<Double>(value, false));
}
int32_t __fixdfsi(double value) {
  return static_cast<int32_t>(truncated<Double>(bits(value)));
}
uint32_t __fixunsdfsi(double value) {
  return truncated<Double>(bits(value));
}
uint32_t __fixunssfsi(float value) {
  return truncated<Single>(bits(value));
}
double __extendsfdf2(float value) {
  const Number<Single> number(bits(value));
  const uint64_t sign = uint64_t{number.sign} << 32;
  if (number.is_special()) {
    return dual(sign | (number.is_nan() ? Double::kNan : Double::kInfinity));
  }
  constexpr int kUp = Double::kFraction - Single::kFraction;
  return dual(pack<Double>(sign, number.exponent - Single::kBias + Double::kBias,
                           uint64_t{number.mantissa} << (kUp + 3)));
}
float __truncdfsf2(double value) {
  const Number<Double> number(bits(value));
  const auto sign = static_cast<uint32_t>(number.sign >> 32);
  if (number.is_special()) {
    return single(sign | (number.is_nan() ? Single::kNan : Single::kInfinity));
  }
  constexpr int kDown = Double::kFraction - Single::kFraction - 3;
  return single(pack<Single>(sign, number.exponent - Double::kBias + Single::kBias,
                             static_cast<uint32_t>(shift_right(number.mantissa, kDown))));
}
}
