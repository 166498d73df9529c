#include "evaluate/report.hpp"

#include <algorithm>
#include <cstdio>

namespace flashbvh::bench {
namespace {

constexpr int kSecondsDigits = 7;

std::string plural(std::uint32_t count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string space(width - text.size(), ' ');
  return left ? text + space : space + text;
}

std::string markdown_line(const std::vector<std::string>& cells,
                          const std::vector<std::size_t>& widths) {
  std::string line = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += " " + padded(cells[i], widths[i], i == 0) + " |";
  }
  return line + "\n";
}

std::vector<std::string> cells_of(const RowResult& row) {
  return {row.algorithm,
          fixed_digits(row.times.least, kSecondsDigits),
          fixed_digits(row.times.most, kSecondsDigits),
          fixed_digits(row.times.mean, kSecondsDigits),
          fixed_digits(row.times.deviation, kSecondsDigits),
          std::to_string(row.counts.visits),
          std::to_string(row.counts.overlaps),
          std::to_string(row.counts.leaf_pairs),
          std::to_string(row.counts.triangle_pairs)};
}

}  // namespace

std::string fixed_digits(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string markdown_table(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines[0].size(), 0);
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], line[i].size());
    }
  }
  std::vector<std::string> rule;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    rule.push_back(i == 0 ? std::string(widths[i], '-') : std::string(widths[i] - 1, '-') + ":");
  }
  std::string text = markdown_line(lines[0], widths) + markdown_line(rule, widths);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    text += markdown_line(lines[i], widths);
  }
  return text;
}

std::string table_heading(std::uint32_t table) {
  return "### Table " + std::to_string(table) + ": " + scene::table_title(table) + "\n";
}

std::string setup_table(const SetupResult& result) {
  std::vector<std::vector<std::string>> lines = {{"algorithm", "min.", "max.", "mean",
                                                  "std. deviation", "iterations", "overlaps",
                                                  "leaf overlaps", "geometry overlaps"}};
  for (const RowResult& row : result.rows) {
    lines.push_back(cells_of(row));
  }
  lines.push_back({"best rule", "", "", "", "",
                   result.best_rule ? std::to_string(*result.best_rule) : "-", "", "", ""});
  return std::string("**") + result.setup->name + "** (" +
         plural(result.repetitions, "repetition") + ", " + plural(result.rounds, "round") +
         ", seconds)\n\n" + markdown_table(lines);
}

}  // namespace flashbvh::bench
