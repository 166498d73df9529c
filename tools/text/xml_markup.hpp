// The levels of an XML text, found as TinyXML finds them but without recursion.
#pragma once

#include <cstddef>
#include <string_view>

namespace flashbvh::tool {

/// The position after `mark`, searched for from a position; the text's size if there is none.
std::size_t behind(std::string_view text, std::string_view mark, std::size_t from = 0);

/// The levels at which TinyXML nests elements, also in a malformed text: 0 without elements. Never
/// fewer than TinyXML does, and more only behind an error.
std::size_t levels_of(std::string_view text);

}  // namespace flashbvh::tool
