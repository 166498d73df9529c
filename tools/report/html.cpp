#include "report/html.hpp"

#include "flashbvh/version.hpp"
#include "report/drawing.hpp"
#include "report/style.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD";

std::uint32_t byte_at(const std::string& text, std::size_t place) {
  return place < text.size() ? static_cast<std::uint8_t>(text[place]) : 0;
}

/// Bytes of the well-formed character at `place`, 0 if there is none (Unicode, table 3-7).
std::size_t character_length(const std::string& text, std::size_t place) {
  const std::uint32_t first = byte_at(text, place);
  if (first < 0x80) {
    return first < 0x20 || first == 0x7F ? 0 : 1;
  }
  const std::size_t length = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (length == 0 || first > 0xF4) {
    return 0;
  }
  const std::uint32_t second = byte_at(text, place + 1);
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
      (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90)) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte_at(text, place + i) & 0xC0) != 0x80) {
      return 0;
    }
  }
  return length;
}

std::string escaped_character(const std::string& character) {
  switch (character[0]) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return character;
  }
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string html;
  for (std::size_t place = 0; place < text.size();) {
    const std::size_t length = character_length(text, place);
    html += length == 0 ? kReplacement : escaped_character(text.substr(place, length));
    place += length == 0 ? 1 : length;
  }
  return html;
}

std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t place = text.size(); place > 3; place -= 3) {
    text.insert(place - 3, ",");
  }
  return text;
}

std::string percent(std::uint64_t part, std::uint64_t whole) {
  return fixed(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1) + " %";
}

std::string counted(std::uint64_t number, const char* one, const char* many) {
  return grouped(number) + " " + (number == 1 ? one : many);
}

std::string key(const std::string& style, const std::string& text) {
  return "<span><i class=\"key " + style + "\"></i>" + text + "</span>\n";
}

std::string fact(const std::string& name, const std::string& value, const std::string& note) {
  return "<div><dt>" + name + "</dt><dd>" + value +
         (note.empty() ? "" : "<small>" + note + "</small>") + "</dd></div>\n";
}

std::string page_begin(const std::string& title, const char* command, const char* lead,
                       const std::string& style) {
  return concat(
      "<!DOCTYPE html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n"
      "<meta name=viewport content=\"width=device-width,initial-scale=1\">\n<title>",
      title, " &middot; flashbvh ", command, "</title>\n<style>\n", kColours, kText, kTables,
      kPictures, paint_style(), style,
      "</style>\n</head>\n<body>\n<header>\n<p class=lead>flashbvh ", command, ": ", lead,
      "</p>\n<h1>", title, "</h1>\n</header>\n<main>\n");
}

std::string page_end() {
  return concat("<footer><p class=note>flashbvh ", FLASHBVH_VERSION_MAJOR, ".",
                FLASHBVH_VERSION_MINOR, ".", FLASHBVH_VERSION_PATCH,
                "</p></footer>\n</main>\n</body>\n</html>\n");
}

std::string table(const std::string& caption, const std::vector<Column>& columns,
                  const std::vector<std::vector<std::string>>& rows) {
  const auto cell = [&](const char* tag, std::size_t column, const char* scope,
                        const std::string& content) {
    return std::string("<") + tag + scope + (columns[column].is_number ? " class=n>" : ">") +
           content + "</" + tag + ">";
  };
  std::string html = "<div class=scroll><table><caption>" + caption + "</caption>\n<thead><tr>";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    html += cell("th", i, " scope=col", columns[i].title);
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      html += i == 0 ? cell("th", i, " scope=row", row[i]) : cell("td", i, "", row[i]);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace flashbvh::tool
