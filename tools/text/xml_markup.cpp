#include "text/xml_markup.hpp"

#include <algorithm>
#include <cctype>

namespace flashbvh::tool {
namespace {

using Kind = Markup::Kind;

bool begins_at(std::string_view text, std::size_t at, std::string_view with) {
  return text.compare(at, with.size(), with) == 0;
}

bool begins_in_any_case(std::string_view text, std::size_t at, std::string_view with) {
  const std::string_view found = text.substr(at, with.size());
  return std::equal(found.begin(), found.end(), with.begin(), with.end(), [](char p, char q) {
    return std::tolower(static_cast<unsigned char>(p)) == q;
  });
}

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// TinyXML takes all bytes from 127 for letters.
bool is_letter(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 127 || std::isalpha(byte) != 0 || c == '_';
}

bool is_of_name(char c) {
  return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("-.:").find(c) != std::string_view::npos;
}

/// In texts and in quotes, TinyXML takes as many bytes as a character's first byte announces.
std::size_t announced_bytes(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte < 0xC2 || byte > 0xF4 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

/// The position of `mark`, which is at the beginning of a character; the text's size if there is
/// none.
std::size_t find_character(std::string_view text, std::string_view mark, std::size_t from) {
  while (from < text.size() && !begins_at(text, from, mark)) {
    from += announced_bytes(text[from]);
  }
  return std::min(from, text.size());
}

/// The position after blanks and byte order marks.
std::size_t behind_blanks(std::string_view text, std::size_t at) {
  for (;;) {
    if (at < text.size() && is_space(text[at])) {
      ++at;
    } else if (begins_at(text, at, "\xEF\xBB\xBF") || begins_at(text, at, "\xEF\xBF\xBE") ||
               begins_at(text, at, "\xEF\xBF\xBF")) {
      at += 3;
    } else {
      return at;
    }
  }
}

std::size_t behind_name(std::string_view text, std::size_t at) {
  if (at < text.size() && is_letter(text[at])) {
    while (at < text.size() && is_of_name(text[at])) {
      ++at;
    }
  }
  return at;
}

/// Without quotes, a value ends at a blank or at the tag's end.
std::size_t behind_bare_value(std::string_view text, std::size_t at) {
  while (at < text.size() && !is_space(text[at]) && text[at] != '/' && text[at] != '>') {
    if (text[at] == '"' || text[at] == '\'') {
      return text.size();
    }
    ++at;
  }
  return at;
}

/// The position after NAME="VALUE"; the text's size if it is malformed.
std::size_t behind_attribute(std::string_view text, std::size_t at) {
  const std::size_t name_end = behind_name(text, at);
  const std::size_t equals = behind_blanks(text, name_end);
  if (name_end == at || equals >= text.size() || text[equals] != '=') {
    return text.size();
  }
  const std::size_t value = behind_blanks(text, equals + 1);
  if (value < text.size() && (text[value] == '"' || text[value] == '\'')) {
    return std::min(find_character(text, text.substr(value, 1), value + 1) + 1, text.size());
  }
  return behind_bare_value(text, value);
}

/// Of a declaration, TinyXML reads three attributes, whose values may hold a '>'. `at`: behind
/// "<?xml".
std::size_t behind_declaration(std::string_view text, std::size_t at) {
  while (at < text.size() && text[at] != '>') {
    at = behind_blanks(text, at);
    if (begins_in_any_case(text, at, "version") || begins_in_any_case(text, at, "encoding") ||
        begins_in_any_case(text, at, "standalone")) {
      at = behind_attribute(text, at);
    } else {
      while (at < text.size() && text[at] != '>' && !is_space(text[at])) {
        ++at;
      }
    }
  }
  return std::min(at + 1, text.size());
}

Markup tag_at(std::string_view text, std::size_t begin) {
  std::size_t at = behind_blanks(text, behind_name(text, begin + 1));
  while (at < text.size() && text[at] != '>' && text[at] != '/') {
    at = behind_blanks(text, behind_attribute(text, at));
  }
  if (at >= text.size()) {
    return {Kind::start, begin, text.size()};
  }
  if (text[at] == '>') {
    return {Kind::start, begin, at + 1};
  }
  return begins_at(text, at, "/>") ? Markup{Kind::empty, begin, at + 2}
                                   : Markup{Kind::start, begin, text.size()};
}

Markup markup_at(std::string_view text, std::size_t at) {
  if (begins_at(text, at, "<!--")) {
    return {Kind::other, at, behind(text, "-->", at + 4)};
  }
  if (begins_at(text, at, "<![CDATA[")) {
    return {Kind::other, at, behind(text, "]]>", at + 9)};
  }
  if (begins_in_any_case(text, at, "<?xml")) {
    return {Kind::other, at, behind_declaration(text, at + 5)};
  }
  if (at + 1 < text.size() && is_letter(text[at + 1])) {
    return tag_at(text, at);
  }
  return {begins_at(text, at, "</") ? Kind::end : Kind::other, at, behind(text, ">", at)};
}

}  // namespace

std::size_t behind(std::string_view text, std::string_view mark, std::size_t from) {
  const std::size_t at = text.find(mark, from);
  return at == std::string_view::npos ? text.size() : at + mark.size();
}

std::optional<Markup> next_markup(std::string_view text, std::size_t from) {
  const std::size_t at = find_character(text, "<", from);
  return at == text.size() ? std::nullopt : std::optional(markup_at(text, at));
}

std::size_t levels_of(std::string_view text) {
  std::size_t level = 0;
  std::size_t most = 0;
  std::size_t at = 0;
  for (std::optional<Markup> found = next_markup(text, 0); found; found = next_markup(text, at)) {
    if (level == 0 && behind_blanks(text, at) != found->begin) {
      break;  // TinyXML reads no text outside the root
    }
    at = found->end;
    level += found->kind == Kind::start ? 1 : 0;
    level -= found->kind == Kind::end && level != 0 ? 1 : 0;
    most = std::max(most, level + (found->kind == Kind::empty ? 1 : 0));
  }
  return most;
}

}  // namespace flashbvh::tool
