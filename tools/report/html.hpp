// Pieces of HTML.
#ifndef FLASHBVH_TOOLS_REPORT_HTML_HPP
#define FLASHBVH_TOOLS_REPORT_HTML_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace flashbvh::tool {

/// Text as it may stand between tags and in attributes. Bytes that are no UTF-8 and control
/// characters become U+FFFD.
std::string escaped(const std::string& text);

/// "1,234,567".
std::string grouped(std::uint64_t number);

/// "12.3 %"; `whole` is not 0.
std::string percent(std::uint64_t part, std::uint64_t whole);

/// "1 box", "12 boxes".
std::string counted(std::uint64_t number, const char* one, const char* many);

/// A square in the colour of a style class, and what it stands for, HTML.
std::string key(const std::string& style, const std::string& text);

/// Of a list of facts, all HTML.
std::string fact(const std::string& name, const std::string& value, const std::string& note = "");

/// A page up to its first section. `title` and `lead` are HTML; `command`: which writes it;
/// `style`: beside that of all pages.
std::string page_begin(const std::string& title, const char* command, const char* lead,
                       const std::string& style);
/// Behind the last section, with the version.
std::string page_end();

struct Column {
  const char* title;
  bool is_number;
};

/// A table that scrolls by itself where the page is narrow. Cells are HTML; the first of each row
/// is its head.
std::string table(const std::string& caption, const std::vector<Column>& columns,
                  const std::vector<std::vector<std::string>>& rows);

}  // namespace flashbvh::tool

#endif
