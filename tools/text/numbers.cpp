#include "text/numbers.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "text/printed.hpp"

namespace flashbvh::tool {
namespace {

#ifdef __cpp_lib_to_chars
template <class Number, class... Format>
std::string to_text(Number value, Format... format) {
  std::array<char, 400> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format...);
  return std::string(text.data(), end.ptr);
}

std::optional<double> parse(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ptr != end || result.ec == std::errc::invalid_argument) {
    return std::nullopt;
  }
  if (result.ec == std::errc::result_out_of_range) {
    value = std::strtod(std::string(text).c_str(), nullptr);  // near zero, unless infinite
  }
  return value;
}
#else
using printed::parse;
using printed::to_text;
#endif

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
  return to_text(value);
}

std::string floating_literal(double value) {
  return with_point(to_text(value));
}

std::string float_literal(float value) {
  return with_point(to_text(std::isfinite(value) ? value : 0.0f)) + "f";
}

std::string fixed(double value, int digits) {
  return to_text(value, std::chars_format::fixed, digits);
}

std::string significant(double value, int digits) {
  return to_text(value, std::chars_format::general, digits);
}

std::optional<double> parse_number(std::string_view text) {
  const std::optional<double> value = parse(without_plus(text));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<long long> parse_integer(std::string_view text) {
  text = without_plus(text);
  long long value = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end ? std::optional(value) : std::nullopt;
}

}  // namespace flashbvh::tool
