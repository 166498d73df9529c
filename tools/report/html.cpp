#include "report/html.hpp"

#include <utility>

#include "flashbvh/version.hpp"
#include "report/picture.hpp"
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
  constexpr std::pair<char, const char*> kEntities[] = {
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  for (const auto& [special, entity] : kEntities) {
    if (character[0] == special) {
      return entity;
    }
  }
  return character;
}

/// "th" or "td" with its content.
std::string cell(const std::string& tag, const std::string& attributes,
                 const std::string& content) {
  return "<" + tag + attributes + ">" + content + "</" + tag + ">";
}

std::string whole_table(const std::string& style, const std::string& caption,
                        const std::string& head, const std::string& body) {
  return "<div class=scroll><table" + style + ">" +
         (caption.empty() ? "" : "<caption>" + caption + "</caption>") + "\n<thead><tr>" + head +
         "</tr></thead>\n<tbody>\n" + body + "</tbody></table></div>\n";
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

std::string counted(std::uint64_t number, const char* one, const char* many) {
  return grouped(number) + " " + (number == 1 ? one : many);
}

std::string square(const std::string& style) {
  return "<i class=\"key " + style + "\"></i>";
}

std::string key(const std::string& style, const std::string& text) {
  return "<span>" + square(style) + text + "</span>\n";
}

std::string fact(const std::string& name, const std::string& value, const std::string& note) {
  return "<div><dt>" + name + "</dt><dd>" + value +
         (note.empty() ? "" : "<small>" + note + "</small>") + "</dd></div>\n";
}

std::string facts(const std::string& items) {
  return "<dl class=facts>\n" + items + "</dl>\n";
}

std::string note(const std::string& text) {
  return "<p class=note>" + text + "</p>\n";
}

std::string verdict_line(const std::string& style, const std::string& what, const std::string& of) {
  return "<li" + style + "><b>" + what + "</b>" + of + "</li>\n";
}

std::string section(const std::string& id, const std::string& title, const std::string& body) {
  return "<section" + (id.empty() ? "" : " id=" + id) + ">" +
         (title.empty() ? "" : "<h2>" + title + "</h2>") + "\n" + body + "</section>\n";
}

std::string page(const std::string& title, const char* command, const char* lead,
                 const std::string& body) {
  return concat(
      "<!DOCTYPE html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n"
      "<meta name=viewport content=\"width=device-width,initial-scale=1\">\n<title>",
      title, " &middot; flashbvh ", command, "</title>\n<style>\n", kColours, kText, kTables,
      kPictures, paint_style(), "</style>\n</head>\n<body>\n<header>\n<p class=lead>flashbvh ",
      command, ": ", lead, "</p>\n<h1>", title, "</h1>\n</header>\n<main>\n", body,
      "</main>\n</body>\n</html>\n");
}

std::string version_text() {
  return concat("flashbvh ", FLASHBVH_VERSION_MAJOR, ".", FLASHBVH_VERSION_MINOR, ".",
                FLASHBVH_VERSION_PATCH);
}

std::string table(const std::string& caption, const Cells& columns,
                  const std::vector<Cells>& rows) {
  const auto is_number = [&](std::size_t i) { return columns[i][0] == '#'; };
  std::string head;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    head += cell("th", std::string(" scope=col") + (is_number(i) ? " class=n" : ""),
                 columns[i].substr(is_number(i) ? 1 : 0));
  }
  std::string body;
  for (const Cells& row : rows) {
    body += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      body += i == 0 ? cell("th", " scope=row", row[i])
                     : cell("td", is_number(i) ? " class=n" : "", row[i]);
    }
    body += "</tr>\n";
  }
  return whole_table("", caption, head, body);
}

std::string matrix(const std::string& style, const std::string& caption, const Cells& rows,
                   const Cells& columns,
                   const std::function<std::string(std::size_t, std::size_t)>& cell_at) {
  std::string head = "<td></td>";
  for (const std::string& column : columns) {
    head += cell("th", " scope=col", column);
  }
  std::string body;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    body += "<tr>" + cell("th", " scope=row", rows[i]);
    for (std::size_t j = 0; j < columns.size(); ++j) {
      body += cell_at(i, j);
    }
    body += "</tr>\n";
  }
  return whole_table(" class=\"matrix " + style + "\"", caption, head, body);
}

}  // namespace flashbvh::tool
