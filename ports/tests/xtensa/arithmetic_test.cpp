// Compares the port's arithmetic for the LX106 with this machine's: every kind of number, with
// random bits.
#include <stdint.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>

#include "support/random.hpp"

namespace whole {
#include "xtensa/arithmetic.cpp"
}
namespace real {
#include "xtensa/float.cpp"
}

namespace {

using flashbvh::test::Random;

constexpr int kCases = 20000;

/// Random bits, often few or nearly all of them set, so that carries, ties and powers of two occur.
uint64_t any_bits(Random& random) {
  const uint64_t bits = random.next();
  switch (random.below(4)) {
    case 0:
      return bits;
    case 1:
      return bits >> random.below(64);
    case 2:
      return ~(bits >> random.below(64));
    default:
      return bits & (~uint64_t{0} << random.below(64));
  }
}

/// A random number, often close to `near`, or at an end of the range.
template <class Real, class Bits>
Real any_number(Random& random, Real near) {
  Bits bits = static_cast<Bits>(any_bits(random) >> (64 - 8 * sizeof(Bits)));
  const Real special[] = {0,
                          -Real{0},
                          std::numeric_limits<Real>::infinity(),
                          std::numeric_limits<Real>::quiet_NaN(),
                          std::numeric_limits<Real>::denorm_min(),
                          std::numeric_limits<Real>::max(),
                          std::numeric_limits<Real>::min(),
                          Real{1}};
  Real value;
  switch (random.below(4)) {
    case 0:
      return special[random.below(8)];
    case 1: {
      std::memcpy(&bits, &near, sizeof near);
      bits ^= Bits{1} << random.below(8 * sizeof(Bits));
      break;
    }
    default:
      break;
  }
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

template <class Real>
bool is_same(Real a, Real b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

}  // namespace

TEST_CASE("xtensa: products and quotients of integers") {
  Random random(flashbvh::test::test_seed());
  for (int i = 0; i < kCases; ++i) {
    const uint64_t a = any_bits(random);
    const uint64_t b = any_bits(random);
    const auto x = static_cast<uint32_t>(a);
    const auto y = static_cast<uint32_t>(b);
    const auto product =
        static_cast<uint64_t>(whole::__muldi3(static_cast<int64_t>(a), static_cast<int64_t>(b)));
    bool good = product == a * b && whole::__umulsidi3(x, y) == uint64_t{x} * y;
    if (b != 0) {
      good = good && whole::__udivdi3(a, b) == a / b && whole::__umoddi3(a, b) == a % b;
      const auto s = static_cast<int64_t>(a);
      const auto t = static_cast<int64_t>(b);
      good =
          good && (t == -1 || (whole::__divdi3(s, t) == s / t && whole::__moddi3(s, t) == s % t));
    }
    if (y != 0) {
      good = good && whole::__udivsi3(x, y) == x / y && whole::__umodsi3(x, y) == x % y;
      const auto s = static_cast<int32_t>(x);
      const auto t = static_cast<int32_t>(y);
      good =
          good && (t == -1 || (whole::__divsi3(s, t) == s / t && whole::__modsi3(s, t) == s % t));
    }
    CAPTURE(a, b);
    REQUIRE(good);
  }
}

TEST_CASE("xtensa: floats and doubles to the bit") {
  Random random(flashbvh::test::test_seed());
  for (int i = 0; i < kCases; ++i) {
    const auto a = any_number<double, uint64_t>(random, 1);
    const auto b = any_number<double, uint64_t>(random, a);
    const auto x = any_number<float, uint32_t>(random, 1);
    const auto y = any_number<float, uint32_t>(random, x);
    CAPTURE(a, b, x, y);
    REQUIRE(is_same(real::__adddf3(a, b), a + b));
    REQUIRE(is_same(real::__subdf3(a, b), a - b));
    REQUIRE(is_same(real::__muldf3(a, b), a * b));
    REQUIRE(is_same(real::__divdf3(a, b), a / b));
    REQUIRE(is_same(real::__addsf3(x, y), x + y));
    REQUIRE(is_same(real::__subsf3(x, y), x - y));
    REQUIRE(is_same(real::__mulsf3(x, y), x * y));
    REQUIRE(is_same(real::__truncdfsf2(a), static_cast<float>(a)));
    REQUIRE(is_same(real::__extendsfdf2(x), static_cast<double>(x)));
  }
}

TEST_CASE("xtensa: whole numbers to floats and back") {
  Random random(flashbvh::test::test_seed());
  for (int i = 0; i < kCases; ++i) {
    const auto bits = static_cast<uint32_t>(any_bits(random));
    const auto value = static_cast<int32_t>(bits);
    CAPTURE(bits);
    REQUIRE(is_same(real::__floatsisf(value), static_cast<float>(value)));
    REQUIRE(is_same(real::__floatunsisf(bits), static_cast<float>(bits)));
    REQUIRE(is_same(real::__floatsidf(value), static_cast<double>(value)));
    REQUIRE(is_same(real::__floatunsidf(bits), static_cast<double>(bits)));
    const double part = random.below(1u << 20) / 1048576.0;
    REQUIRE(real::__fixdfsi(value + part) == static_cast<int32_t>(value + part));
    REQUIRE(real::__fixunsdfsi(bits + part) == static_cast<uint32_t>(bits + part));
    REQUIRE(real::__fixunssfsi(static_cast<float>(bits >> 1)) ==
            static_cast<uint32_t>(static_cast<float>(bits >> 1)));
  }
}
