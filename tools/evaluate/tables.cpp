#include <algorithm>

#include "evaluate/run.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using Line = std::vector<std::string>;

std::string markdown_line(const Line& cells, const std::vector<std::size_t>& widths) {
  std::string line = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string space(widths[i] - cells[i].size(), ' ');
    line += " " + (i == 0 ? cells[i] + space : space + cells[i]) + " |";
  }
  return line + "\n";
}

/// The first line is the head. The first column is left-aligned, the others right.
std::string markdown_table(const std::vector<Line>& lines) {
  std::vector<std::size_t> widths(lines[0].size(), 0);
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], line[i].size());
    }
  }
  Line rule;
  for (const std::size_t width : widths) {
    rule.push_back(rule.empty() ? std::string(width, '-') : std::string(width - 1, '-') + ":");
  }
  std::string text = markdown_line(lines[0], widths) + markdown_line(rule, widths);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    text += markdown_line(lines[i], widths);
  }
  return text;
}

}  // namespace

std::string setup_table(const SetupResult& result) {
  std::vector<Line> lines = {{"algorithm", "min.", "max.", "mean", "std. deviation", "iterations",
                              "overlaps", "leaf overlaps", "geometry overlaps"}};
  for (const Row& row : result.rows) {
    const QueryStats& counts = row.counts;
    const Times times = times_of(row.seconds);
    lines.push_back({row.name});
    for (const double seconds : {times.least, times.most, times.mean, times.deviation}) {
      lines.back().push_back(fixed(seconds, 7));
    }
    for (const std::uint32_t count :
         {counts.visits, counts.overlaps, counts.leaf_pairs, counts.triangle_pairs}) {
      lines.back().push_back(std::to_string(count));
    }
  }
  return concat("**", result.setup->name, "** (seconds; repetitions: ", result.repetitions,
                ", rounds: ", result.rows[0].seconds.size(), ")\n\n", markdown_table(lines));
}

std::string figure_33(const std::vector<SetupResult>& results) {
  std::vector<Line> lines = {{"faces"}};
  for (const Row& row : results.front().rows) {
    lines[0].push_back(row.name);
  }
  for (const SetupResult& result : results) {
    lines.push_back({std::to_string(result.setup->a.faces())});
    for (const Row& row : result.rows) {
      lines.back().push_back(fixed(times_of(row.seconds).mean / result.repetitions, 7));
    }
  }
  return concat("### Figure 33: mean seconds of one query over faces\n\n", markdown_table(lines));
}

}  // namespace flashbvh::tool
