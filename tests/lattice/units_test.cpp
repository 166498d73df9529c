// Lengths in the mesh's unit: exact products, rounded once.
#include "flashbvh/float.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

std::uint64_t bits_of(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

float length_of(std::int64_t fine, double cell) {
  return float_of(length_bits(fine, bits_of(cell)));
}

constexpr std::int64_t kMostFine = std::int64_t{1} << 39;

std::int64_t any_fine(Random& random) {
  const std::int64_t high = random.between(-(1 << 28), 1 << 28);
  const std::int64_t fine = high * 2048 + random.between(0, 2047);
  return fine / (std::int64_t{1} << random.below(38));
}

}  // namespace

TEST_CASE("lengths: a product that a double holds is rounded to a float once, however small") {
  for_rounds(20000, [&](Random& random, int) {
    // A number of 14 bits and one of 39.
    const std::int32_t bits = random.between(1 << 13, (1 << 14) - 1);
    const double cell = std::ldexp(bits, random.between(-190, 80));
    const std::int64_t fine = any_fine(random);
    const double exact = static_cast<double>(fine) * cell / 256;
    REQUIRE(length_of(fine, cell) == static_cast<float>(exact));
  });
}

TEST_CASE("lengths: the ends of the range") {
  CHECK(length_of(0, 1e-300) == 0);
  CHECK(length_of(kMostFine, std::numeric_limits<double>::min()) == 0);
  CHECK(std::isinf(length_of(256, 1e39)));
  CHECK(length_of(-256, 1e39) == -std::numeric_limits<float>::infinity());
  CHECK(length_of(256, 0x1.FFFFFEp127) == std::numeric_limits<float>::max());
  CHECK(std::isinf(length_of(256, 0x1.FFFFFFp127)));  // half way to the next float
  CHECK(length_of(256, 0x1p-149) == std::numeric_limits<float>::denorm_min());
  CHECK(length_of(128, 0x1p-149) == 0);  // a tie rounds to even
  CHECK(length_of(129, 0x1p-149) == std::numeric_limits<float>::denorm_min());
  CHECK(length_of(256, 0x1.0000010000001p0) == 0x1.000002p0f);
  CHECK(length_of(256, 0x1.000001p0) == 1);
  CHECK(millionths_of(256, bits_of(1)) == 1'000'000);
  CHECK(millionths_of(-1, bits_of(1)) == -3906);
  CHECK(millionths_of(0, bits_of(1e300)) == 0);
  CHECK(millionths_of(1, bits_of(1e300)) == INT64_MAX);
  CHECK(millionths_of(-1, bits_of(1e300)) == -INT64_MAX);
  CHECK(millionths_of(kMostFine, bits_of(1e-300)) == 0);
  CHECK(millionths_of(256, bits_of(0x1p41)) == 1'000'000 * (std::int64_t{1} << 41));
  // Up to 2^63: 10^6 = 15,625 * 2^6.
  CHECK(millionths_of(64, bits_of(0x1p45)) == 15'625 * (std::int64_t{1} << 49));
  CHECK(millionths_of(-64, bits_of(0x1p45)) == -15'625 * (std::int64_t{1} << 49));
  CHECK(millionths_of(64, bits_of(0x1p46)) == INT64_MAX);
}

#if defined(__SIZEOF_INT128__)
TEST_CASE("lengths: cells of 53 digits, against integers of 128 bits") {
  __extension__ using Wide = unsigned __int128;
  for_rounds(100000, [&](Random& random, int) {
    const std::uint64_t high = 1u << 20 | random.below(1u << 20);
    const std::uint64_t digits = high << 32 | random.below(UINT32_MAX);
    const double one_to_two = std::ldexp(static_cast<double>(digits), -52);
    const std::int64_t fine = any_fine(random);
    const std::uint64_t size = static_cast<std::uint64_t>(fine < 0 ? -fine : fine);
    const float length = std::ldexp(static_cast<float>(Wide{size} * digits), -60);
    REQUIRE(length_of(fine, one_to_two) == (fine < 0 ? -length : length));

    const Wide millions = Wide{size} * digits * 1'000'000;
    const auto whole = static_cast<std::int64_t>(millions >> 60);
    const auto rest = static_cast<std::uint64_t>(millions) & ((std::uint64_t{1} << 60) - 1);
    constexpr std::uint64_t half = std::uint64_t{1} << 59;
    const std::int64_t rounded = whole + (rest > half || (rest == half && whole % 2 != 0) ? 1 : 0);
    REQUIRE(millionths_of(fine, bits_of(one_to_two)) == (fine < 0 ? -rounded : rounded));

    // Larger cells, up to the range of 63 bits and beyond.
    const int power = static_cast<int>(random.below(12));
    const Wide scaled = (millions << power) + (Wide{1} << 59);
    const Wide large = (scaled >> 60) -
                       ((scaled & ((Wide{1} << 60) - 1)) == 0 && ((scaled >> 60) & 1) != 0 ? 1 : 0);
    const std::int64_t most = large < INT64_MAX ? static_cast<std::int64_t>(large) : INT64_MAX;
    REQUIRE(millionths_of(fine, bits_of(std::ldexp(one_to_two, power))) ==
            (fine < 0 ? -most : most));

    // The adjacent floats lie on either side of half way.
    const float per_unit = cells_per_unit(bits_of(one_to_two));
    const auto tens = static_cast<std::uint64_t>(std::ldexp(per_unit, 24));  // 24 bits, of 25
    const Wide inverse = Wide{1} << (52 + 25);
    REQUIRE(Wide{2 * tens - 1} * digits <= inverse);
    REQUIRE(Wide{2 * tens + 1} * digits >= inverse);
  });
}

TEST_CASE("lengths: rounded up to 1/256 cell, never below and hardly above the exact length") {
  __extension__ using Wide = unsigned __int128;
  constexpr std::uint64_t kTwo52 = std::uint64_t{1} << 52;
  for_rounds(100000, [&](Random& random, int) {
    // Cells whose inverse is near a power of two, or any.
    const std::uint64_t beside = random.below(1u << random.below(31));
    const std::uint64_t upper = random.below(1u << 20);
    const std::uint64_t any = upper << 32 | random.below(UINT32_MAX);
    const std::uint32_t kind = random.below(3);
    const std::uint64_t cell_digits = kind == 0   ? kTwo52 + beside
                                      : kind == 1 ? 2 * kTwo52 - 1 - beside
                                                  : kTwo52 | any;
    const int power = random.between(-20, 20);
    const std::uint64_t length_digits = random.below(1 << 24);
    const int shift = random.between(0, 60);
    const double cell = std::ldexp(static_cast<double>(cell_digits), power - 52);
    const float length = std::ldexp(static_cast<float>(length_digits), power - 60 + shift);
    const float per_unit = cells_per_unit(bits_of(cell));
    const std::uint64_t steps = fine_length_rounded_up(length, per_unit).count;
    const Wide exact = Wide{length_digits} << shift;  // both sides in 2^(power - 52) / 256
    if (steps == UINT32_MAX) {
      REQUIRE(exact + (exact >> 22) > Wide{steps - 1} * cell_digits);
    } else {
      REQUIRE(Wide{steps} * cell_digits >= exact);
      REQUIRE((steps == 0 || Wide{steps - 1} * cell_digits <= exact + (exact >> 22)));
    }
  });
}
#endif

TEST_CASE("lengths: whole steps of a cell of a power of two stay, and errors are no length") {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  const auto steps = [](float length, float per_unit) {
    return fine_length_rounded_up(length, per_unit).count;
  };
  CHECK(steps(3, 1) == 768);
  CHECK(steps(3, 8) == 8 * 768);
  CHECK(steps(0x1.000002p1f, 1) == 513);
  CHECK(steps(0, 50) == 0);
  CHECK(steps(-0.0f, 50) == 0);
  CHECK(steps(std::numeric_limits<float>::denorm_min(), 0x1p-126f) == 1);
  CHECK(steps(16777215, 1) == 16777215u * 256);
  for (const float length : {-1e-9f, infinite, -infinite, std::nanf(""), 16777216.0f}) {
    CHECK(steps(length, 1) == UINT32_MAX);
    CHECK(fine_length_rounded_up(length, 1, {999}).count == UINT32_MAX);
  }
  for (const float per_unit : {0.0f, -1.0f, infinite, std::nanf("")}) {
    CHECK(steps(1, per_unit) == UINT32_MAX);
  }
  CHECK(fine_length_rounded_up(1, 1, {5}).count == 261);
  // 1 / cell is 1 within half of a float's last digit, and not 1.
  CHECK(cells_per_unit(bits_of(1 + 0x1p-30)) > 1);
  CHECK(cells_per_unit(bits_of(1 - 0x1p-30)) > 1);
  CHECK(cells_per_unit(bits_of(0.25)) == 4);
}
