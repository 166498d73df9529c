#include "evaluate/part.hpp"

#include "text/files.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
std::optional<double> parse_clock(const std::string& text) {
  constexpr std::size_t kUnit = 3;
  if (text.size() <= kUnit) {
    return std::nullopt;
  }
  const std::string unit = lower_case(text.substr(text.size() - kUnit));
  std::string number = text.substr(0, text.size() - kUnit);
  number.erase(number.find_last_not_of(' ') + 1);
  const std::optional<double> value = parse_number(number);
  if (!value || (unit != "mhz" && unit != "khz")) {
    return std::nullopt;
  }
  const double megahertz = unit == "mhz" ? *value : *value / 1000;
  return megahertz >= 1e-3 && megahertz <= 1e5 ? std::make_optional(megahertz) : std::nullopt;
}

const std::map<std::string, std::uint32_t>& flash_wait_states() {
  static const std::map<std::string, std::uint32_t> wait_states = {
      {"none", 0},
#include "flash.inc"
  };
  return wait_states;
}

}  // namespace flashbvh::tool
