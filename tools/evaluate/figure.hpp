// The counterpart of the paper's figure 33: how the algorithms scale with the number of faces.
#ifndef FLASHBVH_TOOLS_EVALUATE_FIGURE_HPP
#define FLASHBVH_TOOLS_EVALUATE_FIGURE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "evaluate/run.hpp"

namespace flashbvh::tool {

/// The table that the figure draws.
constexpr std::uint32_t kScalabilityTable = 6;

/// Two panels, iterations and time of one query over faces. Precondition: results of table 6.
std::string figure_33(const std::vector<SetupResult>& results);

}  // namespace flashbvh::tool

#endif
