// The table of the sizes that --simplify reaches: one row per length.
#pragma once

#include <string>
#include <vector>

#include "cli/json.hpp"
#include "simplify/fit.hpp"

namespace flashbvh::tool {

/// Prints to standard output. `leaf_sizes`: one per column.
void print_lengths(const std::vector<simplify::LengthRow>& rows,
                   const std::vector<std::uint32_t>& leaf_sizes, const std::string& unit);
Json json_of(const std::vector<simplify::LengthRow>& rows,
             const std::vector<std::uint32_t>& leaf_sizes);

}  // namespace flashbvh::tool
