#include "live/live_section.hpp"

#include <cstddef>

#include "live/parts.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

std::string base64(const std::uint8_t* bytes, std::size_t size) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) { return i < size ? std::uint32_t{bytes[i]} : 0u; };
  std::string text;
  for (std::size_t i = 0; i < size; i += 3) {
    const std::uint32_t three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (std::size_t digit = 0; digit < 4; ++digit) {
      text += i + digit > size ? '=' : kDigits[three >> (18 - 6 * digit) & 63u];
    }
  }
  return text;
}
/// As they lie in memory, which is little-endian wherever the program runs.
template <class Number>
std::string base64(const std::vector<Number>& numbers) {
  return base64(reinterpret_cast<const std::uint8_t*>(numbers.data()),
                numbers.size() * sizeof(Number));
}

std::string periods_of(const LivePeriods& periods) {
  if (periods.names.empty()) {
    return "";
  }
  std::string names;
  for (const std::string& name : periods.names) {
    names += (names.empty() ? "\"" : ",\"") + name + "\"";
  }
  return concat(",\"values\":\"", base64(periods.values), "\",\"verdicts\":\"", periods.verdicts,
                "\",\"names\":[", names, "]");
}

}  // namespace

bool has_live_section() {
  return *kArmWasm != '\0';
}

std::string live_section(const std::vector<std::uint32_t>& image, const LivePeriods& periods) {
  if (!has_live_section()) {
    return "";
  }
  return concat(
      "<style>\n", kLiveCss, "</style>\n<section id=live hidden>\n<h2>The robot</h2>\n</section>\n",
      "<script type=\"application/json\" id=live-data>{\"image\":\"", base64(image),
      "\",\"library\":\"", kArmWasm, "\"", periods_of(periods), "}</script>\n<script>\n{\n",
      kViewJs, kArmJs, kTrajectoryJs, kLiveJs, "}\n</script>\n");
}

}  // namespace flashbvh::tool
