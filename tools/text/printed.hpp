// Floating-point numbers to text and back by <cstdio>, for standard libraries whose <charconv>
// knows none, as Emscripten's: the same texts and numbers. In the locale of C alone, which the
// program never leaves.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace flashbvh::tool::printed {

/// As std::to_chars: the shortest text that reads back.
std::string to_text(double value);
std::string to_text(float value);
/// As std::to_chars; `format`: fixed or general.
std::string to_text(double value, std::chars_format format, int digits);

/// The whole of `text`, decimal, if std::from_chars would take it; what is too large is infinite.
std::optional<double> parse(std::string_view text);

}  // namespace flashbvh::tool::printed
