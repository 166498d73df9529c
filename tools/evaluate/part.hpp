// What cycles and their time depend on in addition to the core: the part's clock and flash.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace flashbvh::tool {

/// "168MHz", "168 MHz" or "32768kHz" in megahertz; from 0.001 to 100,000, or none.
std::optional<double> parse_clock(const std::string& text);

/// Of each read, with no cache trusted, by the names in ports/cycles/tables/flash.csv; 0 of "none".
const std::map<std::string, std::uint32_t>& flash_wait_states();

}  // namespace flashbvh::tool
