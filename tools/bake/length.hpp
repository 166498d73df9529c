// Square roots, and the length of a vector, rounded equally everywhere: std::hypot of three
// arguments differs between standard libraries.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace flashbvh::bake {

/// No square overflows or vanishes. 0 for a vector of zeros.
inline double length(double x, double y, double z) {
  const double most = std::max({std::fabs(x), std::fabs(y), std::fabs(z)});
  if (most == 0) {
    return 0;
  }
  const auto squared = [most](double part) { return (part / most) * (part / most); };
  return most * std::sqrt(squared(x) + squared(y) + squared(z));
}

/// The square root, rounded down; below 2^32.
inline std::uint64_t square_root(std::uint64_t square) {
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1) {
    if ((root | bit) * (root | bit) <= square) {
      root |= bit;
    }
  }
  return root;
}

}  // namespace flashbvh::bake
