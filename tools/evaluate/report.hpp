// The tables as text: Markdown, aligned so that it reads as it stands.
#ifndef FLASHBVH_TOOLS_EVALUATE_REPORT_HPP
#define FLASHBVH_TOOLS_EVALUATE_REPORT_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "evaluate/run.hpp"

namespace flashbvh::bench {

/// The heading of one of the paper's tables.
std::string table_heading(std::uint32_t table);

/// A setup's rows, in the paper's columns.
std::string setup_table(const SetupResult& result);

/// Lines of cells; the first line is the head. The first column is set left, the others right.
std::string markdown_table(const std::vector<std::vector<std::string>>& lines);

/// With `digits` behind the point.
std::string fixed_digits(double value, int digits);

}  // namespace flashbvh::bench

#endif
