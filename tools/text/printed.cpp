#include "text/printed.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace flashbvh::tool::printed {
namespace {

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

/// Increments the last digit: "1.99e+05" to "2.00e+05". Just below a power of two, numbers are
/// twice as dense: if the nearest text lies there, only the next one may read back as the power.
std::string next(std::string text) {
  for (std::size_t i = text.find('e'); i-- > 0;) {
    if (text[i] == '9') {
      text[i] = '0';
    } else if (text[i] != '.') {
      ++text[i];
      break;
    }
  }
  return text;
}

template <class Number>
std::string scientific(Number value) {
  for (int digits = 0;; ++digits) {
    const std::string text = print("%.*e", digits, static_cast<double>(value));
    for (const std::string& found : {text, next(text)}) {
      if (read(found, value) == value) {
        return found;
      }
    }
  }
}

/// The digits of a scientific text in fixed notation.
std::string fixed_point(const std::string& text, double value) {
  const std::size_t e = text.find('e');
  const int exponent = std::atoi(text.c_str() + e + 1);
  const std::string sign = text[0] == '-' ? "-" : "";
  std::string digits = text.substr(sign.size(), e - sign.size());
  digits.erase(1, 1);
  const auto before = static_cast<std::size_t>(std::abs(exponent));
  if (exponent < 0) {
    return sign + "0." + std::string(before - 1, '0') + digits;
  }
  if (before + 1 >= digits.size()) {
    return print("%.*f", 0, value);
  }
  return sign + digits.insert(before + 1, ".");
}

template <class Number>
std::string shortest_of(Number value) {
  if (!std::isfinite(value)) {
    return print("%.*g", 1, static_cast<double>(value));
  }
  const std::string text = scientific(value);
  const std::string point = fixed_point(text, static_cast<double>(value));
  return point.size() <= text.size() ? point : text;
}

}  // namespace

std::string to_text(double value) {
  return shortest_of(value);
}

std::string to_text(float value) {
  return shortest_of(value);
}

std::string to_text(double value, std::chars_format format, int digits) {
  return print(format == std::chars_format::fixed ? "%.*f" : "%.*g", digits, value);
}

std::optional<double> parse(std::string_view text) {
  const bool is_decimal = text.find_first_not_of("0123456789.eE+-") == std::string_view::npos;
  if (text.empty() || text[0] == '+' || !is_decimal) {
    return std::nullopt;
  }
  const std::string copy(text);
  char* end = nullptr;
  const double value = std::strtod(copy.c_str(), &end);
  return end == copy.c_str() + copy.size() ? std::optional(value) : std::nullopt;
}

}  // namespace flashbvh::tool::printed
