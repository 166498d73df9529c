#include "evaluate/summary.hpp"

#include <algorithm>

#include "evaluate/report.hpp"

namespace flashbvh::bench {
namespace {

double ratio(std::uint64_t part, std::uint64_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

std::string ratio_text(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? "-" : fixed_digits(ratio(part, whole), 4);
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

}  // namespace

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
         "\nLargest ranked / volume of a setup: " + fixed_digits(totals.worst_ranked, 4) + "\n";
}

std::string time_table(const std::vector<SetupResult>& results) {
  std::vector<std::vector<std::string>> lines = {{"microseconds"}};
  for (const RowResult& row : results.front().rows) {
    lines[0].push_back(row.algorithm);
  }
  for (const SetupResult& result : results) {
    lines.push_back({result.setup->name});
    for (const RowResult& row : result.rows) {
      lines.back().push_back(fixed_digits(1e6 * row.times.least / result.repetitions, 3));
    }
  }
  return "### Time of one query (fastest sample)\n\n" + markdown_table(lines);
}

}  // namespace flashbvh::bench
