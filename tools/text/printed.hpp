// Converts floating-point numbers to text and back by <cstdio>, for standard libraries without them
// in <charconv>, such as Emscripten's. Texts and numbers are the same. Works only in the C locale,
// which the program never leaves.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace flashbvh::tool::printed {

/// Like std::to_chars: the shortest text that reads back as the number.
std::string to_text(double value);
std::string to_text(float value);
/// Like std::to_chars; `format`: fixed or general.
std::string to_text(double value, std::chars_format format, int digits);

/// The whole of `text`, decimal, as std::from_chars reads it; too large numbers are infinite.
std::optional<double> parse(std::string_view text);

}  // namespace flashbvh::tool::printed
