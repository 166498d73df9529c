// --simplify and --fit of meshes and robots.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {

/// UserError if both options are given.
inline void check_simplify_or_fit(bool simplify, bool fit) {
  if (simplify && fit) {
    throw UserError("--fit", "chooses what --simplify says; give one of the two");
  }
}

/// The value of --fit. UserError unless it is from 1 to 2^32 - 1.
inline double bytes_to_fit(const std::string& text) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  const std::optional<long long> bytes = parse_integer(text);
  if (!bytes || *bytes < 1 || *bytes > kMost) {
    throw UserError("--fit " + text, "is no number of bytes; give one from 1 to ", kMost);
  }
  return static_cast<double>(*bytes);
}

}  // namespace flashbvh::tool
