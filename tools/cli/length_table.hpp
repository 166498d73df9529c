// What --simplify costs and saves: a row a length.
#pragma once

#include <string>
#include <vector>

#include "cli/json.hpp"
#include "simplify/fit.hpp"

namespace flashbvh::tool {

/// On standard output. `leaf_sizes`: of the columns.
void print_lengths(const std::vector<simplify::LengthRow>& rows,
                   const std::vector<std::uint32_t>& leaf_sizes, const std::string& unit);
Json json_of(const std::vector<simplify::LengthRow>& rows,
             const std::vector<std::uint32_t>& leaf_sizes);

}  // namespace flashbvh::tool
