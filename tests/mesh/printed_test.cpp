// Numbers printed by <cstdio>: equal texts to <charconv>'s, which read as equal numbers.
#include <cmath>
#include <cstring>
#include <limits>

#include "support/test.hpp"
#include "text/numbers.hpp"
#include "text/printed.hpp"

namespace {

template <class Number, class Bits>
Number number_of(Bits bits) {
  Number number;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

template <class Number>
std::string by_charconv(Number value) {
  std::array<char, 400> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

bool is_alike(double value) {
  using Format = std::chars_format;
  const auto narrow = static_cast<float>(value);
  return tool::printed::to_text(value) == by_charconv(value) &&
         tool::printed::to_text(narrow) == by_charconv(narrow) &&
         tool::printed::to_text(value, Format::fixed, 3) == tool::fixed(value, 3) &&
         tool::printed::to_text(value, Format::general, 6) == tool::significant(value, 6);
}

}  // namespace

TEST_CASE("numbers printed by <cstdio> are those of <charconv>") {
  for (int exponent = -1074; exponent <= 1023; ++exponent) {
    CAPTURE(exponent);
    REQUIRE(is_alike(std::ldexp(1.0, exponent)));
    REQUIRE(is_alike(-std::nextafter(std::ldexp(1.0, exponent), 0.0)));
  }
  for (const double value : {0.0, -0.0, 0.1, 1e22, 1e23, 123456.0, 100000.0, 1234567890123456789.0,
                             0.00001, 0.0001, std::numeric_limits<double>::infinity()}) {
    CAPTURE(value);
    REQUIRE(is_alike(value));
  }
  for_rounds(rounds(5000, 1000000), [&](Random& random, int) {
    const auto value = number_of<double>(random.next());
    const std::int32_t digits = random.between(-99999, 99999);
    const double decimal = digits / std::pow(10, random.below(9));
    CAPTURE(value, decimal);
    REQUIRE((!std::isfinite(value) || is_alike(value)));
    REQUIRE(is_alike(decimal));
  });
}

TEST_CASE("words read by <cstdio> are the numbers of <charconv>") {
  for (const char* const word : {"",       "+",     "-",
                                 ".",      "1",     "-1",
                                 "+1",     "++1",   "-+1",
                                 "1.",     ".5",    "1e",
                                 "1e5",    "1e+5",  "1E-5",
                                 "e5",     "1e400", "-1e400",
                                 "1e-400", "inf",   "nan",
                                 "0x10",   " 1",    "1 ",
                                 "1,5",    "1.5.5", "4.9406564584124654e-324"}) {
    CAPTURE(word);
    double value = 0;
    const char* const end = word + std::strlen(word);
    const auto [stop, error] = std::from_chars(word, end, value);
    const bool is_number =
        stop == end && error != std::errc::invalid_argument && std::isfinite(value);
    const auto found = tool::printed::parse(word);
    CHECK(found.has_value() == is_number);
    CHECK((!is_number || error != std::errc() || *found == value));
  }
}
