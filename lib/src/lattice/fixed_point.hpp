// Products of rotations in fixed point; kRotationOne is 1.
#pragma once

#include <stdint.h>

#include "flashbvh/pose.hpp"

namespace flashbvh::detail {

constexpr int64_t fixed_product(int32_t u, int32_t v) {
  return static_cast<int64_t>(u) * v;
}

/// Drops the fraction bits of a rotation, 30, from a sum of products; rounds to the nearest.
constexpr int64_t fixed_rounded_wide(int64_t sum) {
  return (sum + (kRotationOne >> 1)) >> 30;
}
/// fixed_rounded_wide(), if the result fits 32 bits.
constexpr int32_t fixed_rounded(int64_t sum) {
  return static_cast<int32_t>(fixed_rounded_wide(sum));
}

constexpr uint32_t magnitude(int32_t value) {
  return value < 0 ? 0u - static_cast<uint32_t>(value) : static_cast<uint32_t>(value);
}

}  // namespace flashbvh::detail
