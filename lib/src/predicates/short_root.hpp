// Square root of a 32-bit number, rounded down.
#pragma once

#include <stdint.h>

namespace flashbvh::detail {

/// Computes one bit per step.
inline uint32_t short_root(uint32_t value) {
  uint32_t root = 0;
  for (uint32_t bit = 1u << 15; bit != 0; bit >>= 1) {
    const uint32_t longer = root | bit;
    root = longer * longer <= value ? longer : root;
  }
  return root;
}

}  // namespace flashbvh::detail
