// The coordinates that a pose gives a vertex, by the definition in lib/docs/derivations.md, without
// the library's own arithmetic.
#pragma once

#include <stdint.h>

#include "flashbvh/lattice.hpp"
#include "flashbvh/pose.hpp"

namespace flashbvh {

/// The quotient, rounded down.
constexpr int64_t floor_divide(int64_t value, int64_t by) {
  return value / by - (value % by < 0 ? 1 : 0);
}

/// Coordinate `axis` of a vertex of B in A's frame: floor(R p + o + 1/2), where R has 22 fraction
/// bits, o has 14, and the sum of products is rounded down to 14. `origin`: B's.
inline int32_t transformed_coordinate(const int32_t* origin, const Vertex& v, const Pose& pose,
                                      int axis) {
  const int32_t p[3] = {v.x, v.y, v.z};
  int64_t offset =
      pose.translation(axis) * (int64_t{1} << 30) + pose.fraction(axis) * (int64_t{1} << 14);
  int64_t rotated = 0;
  for (int i = 0; i < 3; ++i) {
    const int64_t entry = pose.rotation(axis, i);
    offset += entry * origin[i];
    rotated += floor_divide(entry + 128, 256) * p[i];
  }
  const int64_t sum = floor_divide(rotated, 256) + floor_divide(offset + 32768, 65536);
  return static_cast<int32_t>(floor_divide(sum + 8192, 16384));
}

}  // namespace flashbvh
