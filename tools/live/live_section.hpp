// The section of a page in which a robot answers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace flashbvh::tool {

/// Whether the program was built with the library that answers.
bool has_live_section();

/// Where a robot goes, and what its guard said there.
struct LivePeriods {
  std::vector<float> values;       ///< so many a period, one after the other
  std::string verdicts;            ///< a digit a period
  std::vector<std::string> names;  ///< "line 12 (0.35)"
};

/// HTML: the robot's image, the library, and their script. `periods`: to be played, or
/// none. Without script it stays hidden; "" if the program was built without the library.
std::string live_section(const std::vector<std::uint32_t>& image, const LivePeriods& periods = {});

}  // namespace flashbvh::tool
