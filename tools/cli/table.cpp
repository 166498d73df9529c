#include "cli/table.hpp"

#include <algorithm>
#include <iostream>

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

std::string word_of(const Json& value) {
  return value.is_null()     ? "-"
         : value.is_string() ? value.get<std::string>()
         : value.is_array()  ? joined(value, word_of)
                             : value.dump();
}

std::string number_of(const Json& value, int digits, double scale) {
  return value.is_number_float() ? significant(scale * value.get<double>(), digits)
                                 : word_of(value);
}

}  // namespace

Column word_column(const char* heading, const char* field) {
  return {heading, [field](const Json& row) { return word_of(row.at(field)); }};
}

Column number_column(const char* heading, const char* field, int digits, double scale) {
  return {heading, [=](const Json& row) { return number_of(row.at(field), digits, scale); }, true};
}

std::string pair_text(const Json& row) {
  return word_of(row["a"]) + " - " + word_of(row["b"]);
}

Column pair_column(const char* heading) {
  return {heading, pair_text};
}

void print_table(const Json& rows, const std::vector<Column>& columns) {
  if (rows.empty()) {
    return;
  }
  std::vector<std::string> lines(rows.size() + 1);
  for (const Column& column : columns) {
    std::vector<std::string> cells = {column.heading};
    for (const Json& row : rows) {
      cells.push_back(column.text(row));
    }
    const std::size_t width =
        std::max_element(cells.begin(), cells.end(), [](const auto& one, const auto& other) {
          return one.size() < other.size();
        })->size();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string padding(width - cells[i].size(), ' ');
      lines[i] += (lines[i].empty() ? "" : "  ") +
                  (column.is_number ? padding + cells[i] : cells[i] + padding);
    }
  }
  for (const std::string& line : lines) {
    std::cout << line.substr(0, line.find_last_not_of(' ') + 1) << "\n";
  }
}

void print_answers(bool json, const Json& rows, const std::string& heading,
                   const std::vector<Column>& columns) {
  if (!json) {
    std::cout << heading << "\n";
    print_table(rows, columns);
    return;
  }
  for (const Json& row : rows) {
    print_object(row);
  }
}

}  // namespace flashbvh::tool
