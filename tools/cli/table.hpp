// Tables for people, made of the JSON objects that --json prints.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/json.hpp"

namespace flashbvh::tool {

/// A column: its heading, and the text of a row. Numbers are aligned on the right.
struct Column {
  std::string heading;
  std::function<std::string(const Json& row)> text;
  bool is_number = false;
};

/// A field that is a word or null, which is "-"; an array's elements are joined by commas.
Column word_column(const char* heading, const char* field);
/// A field that is a number, with at most `digits` significant digits; null is "-".
Column number_column(const char* heading, const char* field, int digits = 6);

/// "upper - fore": the links `a` and `b` of a row.
std::string pair_text(const Json& row);
Column pair_column(const char* heading);

/// Prints columns as wide as their widest cell, to standard output; nothing if there are no rows.
void print_table(const Json& rows, const std::vector<Column>& columns);

/// Prints an object a line with --json; else a line with the heading, and a table.
void print_answers(bool json, const Json& rows, const std::string& heading,
                   const std::vector<Column>& columns);

}  // namespace flashbvh::tool
