#include "evaluate/tables.hpp"

#include <algorithm>

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr int kSecondsDigits = 7;

std::string plural(std::uint32_t count, const char* noun) {
  return concat(count, " ", noun, (count == 1 ? "" : "s"));
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
          fixed(row.times.least, kSecondsDigits),
          fixed(row.times.most, kSecondsDigits),
          fixed(row.times.mean, kSecondsDigits),
          fixed(row.times.deviation, kSecondsDigits),
          std::to_string(row.counts.visits),
          std::to_string(row.counts.overlaps),
          std::to_string(row.counts.leaf_pairs),
          std::to_string(row.counts.triangle_pairs)};
}

std::string ratio_text(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? "-" : fixed(ratio(part, whole), 4);
}

std::vector<std::string> line_of(const SetupResult& result) {
  const std::uint64_t volume = result.row("volume-stack").counts.visits;
  const std::uint64_t alternating = result.row("stackless").counts.visits;
  const std::uint64_t ranked = result.row("ranked").counts.visits;
  return {result.setup->name,
          std::to_string(volume),
          std::to_string(alternating),
          std::to_string(result.row("leaf").counts.visits),
          std::to_string(ranked),
          result.best_rule ? std::to_string(*result.best_rule) : "-",
          ratio_text(alternating, volume),
          ratio_text(ranked, volume),
          result.best_rule ? ratio_text(*result.best_rule, volume) : "-"};
}

std::vector<std::string> line_of(const std::string& name, const DefaultTreeVisits& visits) {
  return {name,
          std::to_string(visits.stackless),
          std::to_string(visits.ranked),
          std::to_string(visits.best_rule),
          fixed(visits.ranked_to_stackless(), 4),
          fixed(visits.ranked_to_best(), 4)};
}

}  // namespace

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
  return concat("### Table ", table, ": ", scene::table_title(table), "\n");
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
  for (const RowResult& row : result.shaped) {
    lines.push_back(cells_of(row));
    lines.back()[0] += ", leaves as shapes";
  }
  return std::string("**") + result.setup->name + "** (" +
         plural(result.repetitions, "repetition") + ", " + plural(result.rounds, "round") +
         ", seconds)\n\n" + markdown_table(lines);
}

Totals totals_of(const std::vector<SetupResult>& results) {
  Totals totals;
  for (const SetupResult& result : results) {
    const std::uint64_t volume = result.row("volume-stack").counts.visits;
    const std::uint64_t ranked = result.row("ranked").counts.visits;
    totals.volume += volume;
    totals.alternating += result.row("stackless").counts.visits;
    totals.leaf += result.row("leaf").counts.visits;
    totals.ranked += ranked;
    totals.worst_ranked = std::max(totals.worst_ranked, ratio(ranked, volume));
    if (result.best_rule) {
      totals.best += *result.best_rule;
      totals.volume_by_best += volume;
      totals.ranked_by_best += ranked;
    }
  }
  return totals;
}

std::string summary_table(const std::vector<SetupResult>& results) {
  std::vector<std::vector<std::string>> lines = {{"iterations", "volume-stack", "stackless", "leaf",
                                                  "ranked", "best rule", "stackless / volume",
                                                  "ranked / volume", "best / volume"}};
  for (const SetupResult& result : results) {
    lines.push_back(line_of(result));
  }
  const Totals totals = totals_of(results);
  lines.push_back({"total", std::to_string(totals.volume), std::to_string(totals.alternating),
                   std::to_string(totals.leaf), std::to_string(totals.ranked), "-",
                   ratio_text(totals.alternating, totals.volume),
                   ratio_text(totals.ranked, totals.volume), "-"});
  lines.push_back({"total where the best rule is known", std::to_string(totals.volume_by_best), "",
                   "", std::to_string(totals.ranked_by_best), std::to_string(totals.best), "",
                   ratio_text(totals.ranked_by_best, totals.volume_by_best),
                   ratio_text(totals.best, totals.volume_by_best)});
  return "### Summary\n\n" + markdown_table(lines) +
         "\nLargest ranked / volume of a setup: " + fixed(totals.worst_ranked, 4) + "\n";
}

std::string time_table(const std::vector<SetupResult>& results) {
  std::vector<std::vector<std::string>> lines = {{"microseconds"}};
  for (const RowResult& row : results.front().rows) {
    lines[0].push_back(row.algorithm);
  }
  for (const SetupResult& result : results) {
    lines.push_back({result.setup->name});
    for (const RowResult& row : result.rows) {
      lines.back().push_back(fixed(1e6 * row.times.least / result.repetitions, 3));
    }
  }
  return "### Time of one query (fastest sample)\n\n" + markdown_table(lines);
}

std::string default_tree_table(const std::vector<DefaultTreeResult>& results) {
  std::vector<std::vector<std::string>> lines = {{"iterations", "stackless, paper's tree",
                                                  "ranked, default tree", "best rule, default tree",
                                                  "ranked / stackless", "ranked / best"}};
  for (const DefaultTreeResult& result : results) {
    lines.push_back(line_of(result.setup->name, result.visits));
  }
  lines.push_back(line_of("total of the intersecting", sum_of(results, true)));
  lines.push_back(line_of("total", sum_of(results, false)));
  return "### The default tree\n\n" + markdown_table(lines);
}

}  // namespace flashbvh::tool
