// The tags of an XML text, found as TinyXML finds them but without recursion.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace flashbvh::tool {

/// A tag, or a comment, a CDATA section, a declaration and the like: `other`.
struct Markup {
  enum class Kind : std::uint8_t { start, empty, end, other };
  Kind kind;
  std::size_t begin;  ///< of its '<'
  std::size_t end;    ///< behind it; the text's size if TinyXML gives up in it
};

/// The position after `mark`, searched for from a position; the text's size if there is none.
std::size_t behind(std::string_view text, std::string_view mark, std::size_t from = 0);

/// The first markup from a position outside of markup, or none.
std::optional<Markup> next_markup(std::string_view text, std::size_t from);

/// The levels at which TinyXML nests elements, also in a malformed text: 0 without elements. Never
/// fewer than TinyXML does, and more only behind an error.
std::size_t levels_of(std::string_view text);

}  // namespace flashbvh::tool
