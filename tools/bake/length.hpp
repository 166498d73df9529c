// The length of a vector, rounded equally everywhere: std::hypot of three arguments differs between
// standard libraries.
#pragma once

#include <algorithm>
#include <cmath>

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

}  // namespace flashbvh::bake
