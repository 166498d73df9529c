// Numbers as text: equal texts to <charconv>'s, which read as equal numbers.
#include "text/numbers.hpp"

#include <charconv>
#include <cmath>
#include <cstring>

#include "support/test.hpp"

namespace {

template <class Number>
std::string by_charconv(Number value) {
  std::array<char, 400> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

TEST_CASE("texts of numbers are those of <charconv>") {
  const auto check = [](double value) {
    CAPTURE(value);
    REQUIRE(tool::shortest(value) == by_charconv(value));
    REQUIRE(tool::parse_number(tool::shortest(value)) == value);
    const std::string narrow = by_charconv(static_cast<float>(value));
    REQUIRE(tool::float_literal(static_cast<float>(value)).compare(0, narrow.size(), narrow) == 0);
  };
  for (const double value :
       {0.0, -0.0, 0.1, 1e22, 123456.0, 100000.0, 1234567890123456789.0, 0.00001, 0.0001}) {
    check(value);
  }
  for_rounds(rounds(5000, 1000000), [&](Random& random, int) {
    check(random.between(-99999, 99999) / std::pow(10, random.below(9)));
    check(
        std::ldexp(static_cast<double>(random.next()), static_cast<int>(random.below(120)) - 120));
  });
}

TEST_CASE("words that are numbers are those of <charconv>") {
  for (const char* const word :
       {"",     "-",  ".",   "1",      "-1",  "-+1",  "1.", ".5", "1e",  "1e5",   "1e+5",
        "1E-5", "e5", "inf", "1e-400", "nan", "0x10", " 1", "1 ", "1,5", "1.5.5", "5e-324"}) {
    CAPTURE(word);
    double value = 0;
    const char* const end = word + std::strlen(word);
    const auto [stop, error] = std::from_chars(word, end, value);
    const auto found = tool::parse_number(word);
    CHECK(found.has_value() ==
          (stop == end && error != std::errc::invalid_argument && std::isfinite(value)));
    CHECK((!found || error != std::errc() || *found == value));
  }
  CHECK(tool::parse_number("+1") == 1.0);
  CHECK_FALSE((tool::parse_number("++1") || tool::parse_number("-1e400")));
}
