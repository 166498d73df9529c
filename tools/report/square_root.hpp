// Square roots of integers.
#ifndef FLASHBVH_TOOLS_REPORT_SQUARE_ROOT_HPP
#define FLASHBVH_TOOLS_REPORT_SQUARE_ROOT_HPP

#include <cstdint>

namespace flashbvh::report {

/// The largest number whose square is not above `value`, 0 to 2^62 - 1.
inline std::int64_t square_root(std::int64_t value) {
  std::int64_t root = 0;  // below 2^31
  for (std::int64_t bit = std::int64_t{1} << 30; bit != 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) {
      root += bit;
    }
  }
  return root;
}

}  // namespace flashbvh::report

#endif
