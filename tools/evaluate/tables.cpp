#include "evaluate/run.hpp"

#include <algorithm>

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using Line = std::vector<std::string>;
/// One setup, or the setups of a line of sums.
using Results = std::vector<const SetupResult*>;

/// A column of a summary: a count of a row, its ratio to the same count of the row `of`, or the
/// row's time if there is no count.
struct Column {
  std::string head;
  std::string row;
  std::string of{};
  std::uint32_t QueryStats::*count = &QueryStats::visits;
};

struct Summary {
  std::string heading;
  std::string first_head;
  std::vector<Column> columns;
};

struct Sum {
  std::string name;
  Results results;
};

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string space(width - text.size(), ' ');
  return left ? text + space : space + text;
}

std::string markdown_line(const Line& cells, const std::vector<std::size_t>& widths) {
  std::string line = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += " " + padded(cells[i], widths[i], i == 0) + " |";
  }
  return line + "\n";
}

bool all_have(const Results& results, const std::string& row) {
  return std::all_of(results.begin(), results.end(),
                     [&](const SetupResult* result) { return result->row(row) != nullptr; });
}

std::uint64_t sum_of(const Results& results, const std::string& row,
                     std::uint32_t QueryStats::*count) {
  std::uint64_t sum = 0;
  for (const SetupResult* result : results) {
    sum += result->row(row)->counts.*count;
  }
  return sum;
}

double ratio(const Results& results, const std::string& row, const std::string& of) {
  return static_cast<double>(sum_of(results, row, &QueryStats::visits)) /
         static_cast<double>(sum_of(results, of, &QueryStats::visits));
}

/// The time of the fastest sample.
std::string microseconds(const SetupResult& result, const std::string& row) {
  return fixed(1e6 * times_of(result.row(row)->seconds).least / result.repetitions, 3);
}

std::string cell(const Results& results, const Column& column) {
  if (!all_have(results, column.row) || (!column.of.empty() && results.empty())) {
    return "-";
  }
  if (column.count == nullptr) {
    return microseconds(*results.front(), column.row);
  }
  return column.of.empty() ? std::to_string(sum_of(results, column.row, column.count))
                           : fixed(ratio(results, column.row, column.of), 4);
}

std::string summary_table(const Summary& summary, const Results& results,
                          const std::vector<Sum>& sums) {
  std::vector<Line> lines = {{summary.first_head}};
  for (const Column& column : summary.columns) {
    lines[0].push_back(column.head);
  }
  const auto add = [&](const std::string& name, const Results& of) {
    lines.push_back({name});
    for (const Column& column : summary.columns) {
      lines.back().push_back(cell(of, column));
    }
  };
  for (const SetupResult* result : results) {
    add(result->setup->name, {result});
  }
  for (const Sum& sum : sums) {
    add(sum.name, sum.results);
  }
  return "### " + summary.heading + "\n\n" + markdown_table(lines);
}

const Summary kIterations = {"Summary",
                             "iterations",
                             {{"volume-stack", "volume-stack"},
                              {"stackless", "stackless"},
                              {"leaf", "leaf"},
                              {"ranked", "ranked"},
                              {"best rule", "best rule"},
                              {"stackless / volume", "stackless", "volume-stack"},
                              {"ranked / volume", "ranked", "volume-stack"},
                              {"best / volume", "best rule", "volume-stack"}}};

const Summary kOverlaps = {
    "Overlaps",
    "overlaps",
    {{"volume-stack", "volume-stack", "", &QueryStats::overlaps},
     {"stackless", "stackless", "", &QueryStats::overlaps},
     {"leaf", "leaf", "", &QueryStats::overlaps},
     {"ranked", "ranked", "", &QueryStats::overlaps},
     {"leaf overlaps of all", "volume-stack", "", &QueryStats::leaf_pairs},
     {"geometry overlaps of all", "volume-stack", "", &QueryStats::triangle_pairs}}};

const Summary kDefaultTree = {
    "The default tree",
    "iterations",
    {{"stackless, paper's tree", "stackless"},
     {"ranked, default tree", "ranked, default tree"},
     {"best rule, default tree", "best rule, default tree"},
     {"ranked / stackless", "ranked, default tree", "stackless"},
     {"ranked / best", "ranked, default tree", "best rule, default tree"}}};

template <class Wanted>
Results chosen(const Results& results, const Wanted& wanted) {
  Results some;
  std::copy_if(results.begin(), results.end(), std::back_inserter(some), wanted);
  return some;
}

bool knows_best_rule(const SetupResult* result) {
  return result->row("best rule") != nullptr;
}

bool is_intersecting(const SetupResult* result) {
  return result->rows[0].counts.triangle_pairs != 0;
}

std::string worst_ranked(const Results& results) {
  double worst = 0;
  for (const SetupResult* result : results) {
    worst = std::max(worst, ratio({result}, "ranked", "volume-stack"));
  }
  return "\nLargest ranked / volume of a setup: " + fixed(worst, 4) + "\n";
}

}  // namespace

std::string markdown_table(const std::vector<Line>& lines) {
  std::vector<std::size_t> widths(lines[0].size(), 0);
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], line[i].size());
    }
  }
  Line rule;
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
  std::vector<Line> lines = {{"algorithm", "min.", "max.", "mean", "std. deviation", "iterations",
                              "overlaps", "leaf overlaps", "geometry overlaps"}};
  for (const Row& row : result.rows) {
    const QueryStats& counts = row.counts;
    if (row.leaves == Leaves::none) {
      lines.push_back({row.name, "", "", "", "", std::to_string(counts.visits), "", "", ""});
      continue;
    }
    lines.push_back({row.name});
    const Times times = times_of(row.seconds);
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

std::string summary_tables(const std::vector<SetupResult>& results) {
  Results all;
  Summary times = {"Time of one query (fastest sample)", "microseconds", {}};
  for (const SetupResult& result : results) {
    all.push_back(&result);
  }
  for (const Row& row : results.front().rows) {
    if (row.leaves != Leaves::boxes) {
      break;  // only after the orders on the paper's tree
    }
    times.columns.push_back({row.name, row.name, "", nullptr});
  }
  const Sum total = {"total", all};
  return summary_table(
             kIterations, all,
             {total, {"total where the best rule is known", chosen(all, knows_best_rule)}}) +
         worst_ranked(all) + "\n" + summary_table(kOverlaps, all, {}) + "\n" +
         summary_table(kDefaultTree, all,
                       {{"total of the intersecting", chosen(all, is_intersecting)}, total}) +
         "\n" + summary_table(times, all, {});
}

}  // namespace flashbvh::tool
