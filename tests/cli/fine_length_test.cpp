// Lengths of the command line and of Python, in firmware's steps: against integers of 128 bits.
#include "image/fine_length.hpp"
#include "support/random.hpp"
#include "support/test.hpp"

using namespace flashbvh;

TEST_CASE("a length is the least number of steps that is not below it") {
  __extension__ using Wide = unsigned __int128;
  const auto digits = [](Random& random) {
    const std::uint64_t high = random.below(1u << 21);
    return high << 32 | random.below(UINT32_MAX);
  };
  for_rounds(100000, [&](Random& random, int) {
    const std::uint64_t cell = digits(random) + 1;
    const bool is_whole = random.below(2) == 0;
    const int shift = random.between(0, is_whole ? 0 : 20);
    const std::uint64_t length = is_whole ? cell * random.below(9) / 8 : digits(random);
    const double given = std::ldexp(static_cast<double>(length), shift - 8);
    const auto in_doubles = static_cast<double>(cell);
    const std::uint64_t steps = tool::fine_length_rounded_up(given, in_doubles).count;
    const Wide exact = Wide{length} << shift;
    if (steps == UINT32_MAX) {
      REQUIRE(exact > Wide{UINT32_MAX - 2} * cell);
    } else {
      REQUIRE(Wide{steps} * cell >= exact - (exact >> 49));
      REQUIRE((steps == 0 || Wide{steps - 1} * cell < exact));
    }
  });
}

TEST_CASE("a length below 0, without end or no number is none") {
  for (const double length : {-1e-300, 1e308, HUGE_VAL, std::nan("")}) {
    CHECK(tool::fine_length_rounded_up(length, 1).count == UINT32_MAX);
  }
  CHECK(tool::fine_length_rounded_up(1e308, 1e308).count == 256);
  for (const double cells : {3.0, 50.0, 7.0}) {  // in decimals
    for (const double cell : {0.1, 0.01, 0.001, 0.3, 0.0002}) {
      const double length = std::stod(std::to_string(cells * cell));
      CHECK(tool::fine_length_rounded_up(length, cell).count == 256 * cells);
    }
  }
  CHECK(tool::fine_length_rounded_up(1e-300, 1).count == 1);
}
