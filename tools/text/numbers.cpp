#include "text/numbers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace flashbvh::tool {
namespace {

// By <cstdio>, because not every standard library has floating-point numbers in <charconv>.

std::string print(const char* format, int digits, double value) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), format, digits, value);
  return text.data();
}

double read(const std::string& text, double) {
  return std::strtod(text.c_str(), nullptr);
}
float read(const std::string& text, float) {
  return std::strtof(text.c_str(), nullptr);
}

/// In scientific notation, or in fixed notation if that is no longer.
template <class Number>
std::string shortest_of(Number number) {
  const auto value = static_cast<double>(number);
  int digits = 0;  // after the first one
  std::string text = print("%.*e", digits, value);
  while (std::isfinite(number) && read(text, number) != number) {
    text = print("%.*e", ++digits, value);
  }
  const int exponent = std::atoi(text.c_str() + text.find('e') + 1);
  const std::string point = print("%.*f", std::max(digits - exponent, 0), value);
  return point.size() <= text.size() ? point : text;
}

std::string with_point(const std::string& text) {
  const bool is_floating = text.find_first_of(".e") != std::string::npos;
  return text + (is_floating ? "" : ".0");
}

/// Removes a plus sign, which from_chars does not accept.
std::string_view without_plus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

}  // namespace

std::string shortest(double value) {
  return shortest_of(value);
}

std::string floating_literal(double value) {
  return with_point(shortest_of(value));
}

std::string float_literal(float value) {
  return with_point(shortest_of(std::isfinite(value) ? value : 0.0f)) + "f";
}

std::string fixed(double value, int digits) {
  return print("%.*f", digits, value);
}

std::string significant(double value, int digits) {
  return print("%.*g", digits, value);
}

std::string metres(double length, int digits) {
  const bool is_small = length != 0 && std::fabs(length) < 1e-3;
  return significant(is_small ? 1e6 * length : length, digits) + (is_small ? " um" : " m");
}

std::optional<double> parse_number(std::string_view text) {
  const std::string number(without_plus(text));
  if (number.empty() || number[0] == '+' ||
      number.find_first_not_of("0123456789.eE+-") != std::string::npos) {
    return std::nullopt;
  }
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  return end == number.c_str() + number.size() && std::isfinite(value) ? std::optional(value)
                                                                       : std::nullopt;
}

std::optional<long long> parse_integer(std::string_view text) {
  text = without_plus(text);
  long long value = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end ? std::optional(value) : std::nullopt;
}

}  // namespace flashbvh::tool
