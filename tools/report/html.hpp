// Pieces of HTML for all pages. Arguments are HTML, too, except for escaped().
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace flashbvh::tool {

/// Escapes text for use between tags and in attributes. Replaces invalid UTF-8 and control
/// characters by U+FFFD.
std::string escaped(const std::string& text);

/// A number with separators: "1,234,567".
std::string grouped(std::uint64_t number);

/// A number and its noun: "1 box", "12 boxes".
std::string counted(std::uint64_t number, const char* one, const char* many);

/// A cell in a unit, and the suffix of lengths in it: " mm"; empty if the unit is unknown.
struct Measure {
  double cell;
  std::string suffix;
};
/// A length in the measure's unit, with four digits and the unit.
std::string length_of(const Measure& measure, double length);

/// A square in a style class's colour.
std::string square(const std::string& style);
/// A square and its meaning.
std::string key(const std::string& style, const std::string& text);

/// An item of a list of facts.
std::string fact(const std::string& name, const std::string& value, const std::string& note = "");
std::string facts(const std::string& items);

/// A paragraph in small print.
std::string note(const std::string& text);

/// A line of a list of verdicts; its parts are concatenated.
std::string verdict_line(const std::string& style, const std::string& what, const std::string& of);
/// A verdict of a page: a square in a style class's colour, the verdict, its subject.
std::string decision(const std::string& style, const std::string& what, const std::string& of);
/// The first section of a page.
std::string decision_section(const std::string& title, const std::string& decisions);
/// The text after the last section, with the version.
std::string footer();

/// `id` may be empty.
std::string section(const std::string& id, const std::string& title, const std::string& body);

/// A whole page. `command`: the command that writes the page.
std::string page(const std::string& title, const char* command, const char* lead,
                 const std::string& body);

/// The program and its version: "flashbvh 0.1.0".
std::string version_text();

using Cells = std::vector<std::string>;

/// A table that scrolls separately on narrow pages. The first cell of each row is its head. A
/// column with a title that begins with '#' contains numbers.
std::string table(const std::string& caption, const Cells& columns, const std::vector<Cells>& rows);

/// A table with a row and a column for each name; `cell(row, column)` returns the whole tag.
std::string matrix(const std::string& style, const std::string& caption, const Cells& names,
                   const std::function<std::string(std::size_t, std::size_t)>& cell);

}  // namespace flashbvh::tool
