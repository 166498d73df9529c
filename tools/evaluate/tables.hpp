// Results as Markdown, aligned so that it reads as it stands.
#ifndef FLASHBVH_TOOLS_EVALUATE_TABLES_HPP
#define FLASHBVH_TOOLS_EVALUATE_TABLES_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "evaluate/run.hpp"

namespace flashbvh::tool {

/// Lines of cells; the first line is the head. The first column is set left, the others right.
std::string markdown_table(const std::vector<std::vector<std::string>>& lines);

/// The heading of one of the paper's tables.
std::string table_heading(std::uint32_t table);

/// A setup's rows, in the paper's columns.
std::string setup_table(const SetupResult& result);

/// All setups side by side: iterations, on the default tree too, overlaps and times. Figure 33
/// plots the lines of table 6.
std::string summary_tables(const std::vector<SetupResult>& results);

}  // namespace flashbvh::tool

#endif
