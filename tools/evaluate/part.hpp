// The clock and flash of a part: with the core, they determine cycles and time.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace flashbvh::tool {

/// Converts "168MHz", "168 MHz" or "32768kHz" to megahertz, from 0.001 to 100,000; else none.
std::optional<double> parse_clock(const std::string& text);

/// Wait states of each uncached read, by the names in ports/cycles/tables/flash.csv; "none" has 0.
const std::map<std::string, std::uint32_t>& flash_wait_states();

}  // namespace flashbvh::tool
