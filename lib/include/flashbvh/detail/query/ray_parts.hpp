// Conversion of a ray of floats to integers.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/lattice/float_parts.hpp"
#include "flashbvh/ray.hpp"

namespace flashbvh::detail {

/// Largest coordinate of a segment's end, in cells: a mesh origin's plus a ray's.
constexpr int64_t kMostOfSegment = (int64_t{1} << 29) + kMaxRayCoordinate;

/// Rounds 1/65,536 cell to whole cells, halves up.
inline int64_t whole_cells(int64_t fractions) {
  return (fractions + 0x8000) >> 16;
}

/// Converts a vector of floats to proportional whole numbers below 2^30, the largest of them at
/// least 2^28. False if a float is not finite or all are 0.
inline bool get_direction(const float (&direction)[3], int32_t (&whole)[3]) {
  FloatParts parts[3];
  int32_t highest = INT32_MIN;
  for (int i = 0; i < 3; ++i) {
    parts[i] = parts_of(direction[i]);
    if (!parts[i].is_finite) {
      return false;
    }
    if (parts[i].digits != 0) {
      const int32_t top = parts[i].exponent + 32 - __builtin_clz(parts[i].digits);
      highest = top < highest ? highest : top;
    }
  }
  for (int i = 0; i < 3; ++i) {
    const auto size =
        static_cast<int32_t>(scaled(parts[i].digits, parts[i].exponent + 29 - highest));
    whole[i] = parts[i].is_negative ? -size : size;
  }
  return highest != INT32_MIN;
}

/// part / whole in 31 fraction bits, rounded down: part <= whole < 2^31.
inline uint32_t share_of(uint32_t part, uint32_t whole) {
  uint32_t share = 0;
  for (int bit = 0; bit < 32; ++bit) {
    const bool fits = part >= whole;
    part = (fits ? part - whole : part) << 1;
    share = share << 1 | (fits ? 1 : 0);
  }
  return share;
}

/// `reach`, below 2^37, times `component` / `length` of a direction: within 2^-9 cell.
inline int64_t way_along(int64_t reach, int32_t component, uint32_t length) {
  const bool negative = component < 0;
  const uint32_t share = share_of(static_cast<uint32_t>(negative ? -component : component), length);
  const int64_t way = ((reach >> 16) * share >> 15) + ((reach & 0xFFFF) * share >> 31);
  return negative ? -way : way;
}

}  // namespace flashbvh::detail
