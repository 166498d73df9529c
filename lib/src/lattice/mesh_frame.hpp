// Transforms points from a mesh's frame to its lattice.
#pragma once

#include "flashbvh/lattice.hpp"

namespace flashbvh::detail {

/// Sets a point of a mesh's frame, any 32-bit values, relative to the mesh's origin. False if it is
/// beyond `most` along an axis.
inline bool get_from_origin(const int32_t (&origin)[3], const Point& p, int32_t most,
                            Point& from_origin) {
  const auto fits = [most](int64_t at) { return at >= -most && at <= most; };
  const int64_t x = int64_t{p.x} - origin[0];
  const int64_t y = int64_t{p.y} - origin[1];
  const int64_t z = int64_t{p.z} - origin[2];
  if (!fits(x) || !fits(y) || !fits(z)) {
    return false;
  }
  from_origin = {static_cast<int32_t>(x), static_cast<int32_t>(y), static_cast<int32_t>(z)};
  return true;
}

}  // namespace flashbvh::detail
