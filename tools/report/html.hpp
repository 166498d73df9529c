// Pieces of HTML, of which all pages are made. Arguments are HTML, too, but for those of escaped().
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace flashbvh::tool {

/// Text as it may stand between tags and in attributes. Bytes that are no UTF-8 and control
/// characters become U+FFFD.
std::string escaped(const std::string& text);

/// "1,234,567".
std::string grouped(std::uint64_t number);

/// "1 box", "12 boxes".
std::string counted(std::uint64_t number, const char* one, const char* many);

/// A cell, in a unit, and the text behind lengths in it: " mm"; empty where the unit is unknown.
struct Measure {
  double cell;
  std::string suffix;
};
/// A length, given in the measure's unit, to four digits, with the unit.
std::string length_of(const Measure& measure, double length);

/// A square in the colour of a style class.
std::string square(const std::string& style);
/// A square and its meaning.
std::string key(const std::string& style, const std::string& text);

/// An item of a list of facts.
std::string fact(const std::string& name, const std::string& value, const std::string& note = "");
std::string facts(const std::string& items);

/// A paragraph in small print.
std::string note(const std::string& text);

/// A line of a list of verdicts; nothing is put between its parts.
std::string verdict_line(const std::string& style, const std::string& what, const std::string& of);
/// A verdict of a page: a square in the colour of a style class, the verdict, its subject.
std::string decision(const std::string& style, const std::string& what, const std::string& of);
/// The first section of a page.
std::string decision_section(const std::string& title, const std::string& decisions);
/// Behind the last section, with the version.
std::string footer();

/// `id` may be empty.
std::string section(const std::string& id, const std::string& title, const std::string& body);

/// A whole page. `command`: the command that writes it.
std::string page(const std::string& title, const char* command, const char* lead,
                 const std::string& body);

/// "flashbvh 0.1.0".
std::string version_text();

using Cells = std::vector<std::string>;

/// A table that scrolls by itself where the page is narrow. The first cell of each row is its head.
/// A column whose title begins with '#' is of numbers.
std::string table(const std::string& caption, const Cells& columns, const std::vector<Cells>& rows);

/// A table of all rows and columns; `cell(row, column)`: its whole tag.
std::string matrix(const std::string& style, const std::string& caption, const Cells& rows,
                   const Cells& columns,
                   const std::function<std::string(std::size_t, std::size_t)>& cell);

}  // namespace flashbvh::tool
