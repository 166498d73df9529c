#include "cli/length_table.hpp"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <optional>

#include "text/numbers.hpp"

namespace flashbvh::tool {

std::int64_t bytes_of(const std::string& option, const std::string& text) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  const std::optional<long long> bytes = parse_integer(text);
  if (!bytes || *bytes < 1 || *bytes > kMost) {
    throw UserError(option + " " + text, "is no number of bytes; give one from 1 to ", kMost);
  }
  return *bytes;
}

void print_lengths(const LengthTable& table, const std::string& unit) {
  std::cout << std::left << std::setw(18) << "--simplify" << std::right << std::setw(10)
            << "triangles";
  for (const std::uint32_t leaf_size : table.leaf_sizes) {
    std::cout << std::setw(25) << concat("flash, --leaf-size ", leaf_size);
  }
  std::cout << "\n";
  for (const simplify::LengthRow& row : table.rows) {
    const std::string length =
        row.length == 0 ? "as it is" : shortest(row.length) + (unit.empty() ? "" : " " + unit);
    std::cout << std::left << std::setw(18) << length << std::right << std::setw(10)
              << row.triangles;
    for (const double bytes : row.bytes) {
      std::cout << std::setw(25) << (std::isfinite(bytes) ? fixed(bytes, 0) : "too large");
    }
    std::cout << "\n";
  }
}

Json json_of(const LengthTable& table) {
  Json all = Json::array();
  for (const simplify::LengthRow& row : table.rows) {
    Json flash = Json::object();
    for (std::size_t i = 0; i < table.leaf_sizes.size(); ++i) {
      flash[concat(table.leaf_sizes[i])] =
          std::isfinite(row.bytes[i]) ? Json(row.bytes[i]) : Json();
    }
    all.push_back({{"simplify", row.length}, {"triangles", row.triangles}, {"flash_bytes", flash}});
  }
  return all;
}

}  // namespace flashbvh::tool
