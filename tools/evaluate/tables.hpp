// The tables as text, Markdown, aligned so that it reads as it stands; and all setups side by side:
// iterations as parts of volume-stack's, and times.
#ifndef FLASHBVH_TOOLS_EVALUATE_TABLES_HPP
#define FLASHBVH_TOOLS_EVALUATE_TABLES_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "evaluate/run.hpp"

namespace flashbvh::tool {

/// The heading of one of the paper's tables.
std::string table_heading(std::uint32_t table);

/// A setup's rows, in the paper's columns.
std::string setup_table(const SetupResult& result);

/// Lines of cells; the first line is the head. The first column is set left, the others right.
std::string markdown_table(const std::vector<std::vector<std::string>>& lines);

/// Sums over setups; those of the best rule over the setups that have one.
struct Totals {
  std::uint64_t volume = 0;
  std::uint64_t alternating = 0;
  std::uint64_t leaf = 0;
  std::uint64_t ranked = 0;
  double worst_ranked = 0;           ///< the largest ranked / volume-stack of any setup
  std::uint64_t best = 0;            ///< where known
  std::uint64_t volume_by_best = 0;  ///< volume-stack on the same setups
  std::uint64_t ranked_by_best = 0;
};
Totals totals_of(const std::vector<SetupResult>& results);

/// Iterations: a line a setup and the totals, as text.
std::string summary_table(const std::vector<SetupResult>& results);

/// Microseconds of one query in each row's fastest sample, a line a setup, as text.
std::string time_table(const std::vector<SetupResult>& results);

/// The default tree: a line a setup and the sums, as text.
std::string default_tree_table(const std::vector<DefaultTreeResult>& results);

}  // namespace flashbvh::tool

#endif
