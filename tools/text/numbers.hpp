// Converts numbers to text and back, the same on every machine.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace flashbvh::tool {

/// Concatenates the parts; integers are decimal.
template <class... Parts>
std::string concat(const Parts&... parts) {
  std::string text;
  const auto add = [&text](const auto& part) {
    using Part = std::decay_t<decltype(part)>;
    static_assert(!std::is_same_v<Part, char>, "would be printed as a number");
    if constexpr (std::is_integral_v<Part>) {
      text += std::to_string(part);
    } else {
      text += part;
    }
  };
  (add(parts), ...);
  return text;
}

/// The texts of elements, joined by a separator.
template <class Elements, class TextOf>
std::string joined(const Elements& elements, const TextOf& text_of, const char* separator = ", ") {
  std::string text;
  const char* between = "";
  for (const auto& element : elements) {
    text += concat(between, text_of(element));
    between = separator;
  }
  return text;
}

inline std::string joined(const std::vector<std::string>& words, const char* separator = ", ") {
  return joined(
      words, [](const std::string& word) { return word; }, separator);
}

/// The shortest text that reads back as this number.
std::string shortest(double value);

/// The shortest text as a C++ literal of type double. Precondition: finite.
std::string floating_literal(double value);

/// The shortest text as a C++ literal of type float; 0 if the value is not finite.
std::string float_literal(float value);

/// A text with `digits` digits after the point, for tables.
std::string fixed(double value, int digits);

/// A text with at most `digits` significant digits, for tables.
std::string significant(double value, int digits);

/// "0.0125 m", and below 1 mm "7.99 um", with at most `digits` significant digits.
std::string metres(double length, int digits);

/// The whole of `text` as a finite number (decimal, an optional sign, an optional exponent),
/// rounded to the nearest double.
std::optional<double> parse_number(std::string_view text);

/// The whole of `text` as an integer.
std::optional<long long> parse_integer(std::string_view text);

}  // namespace flashbvh::tool
