// Shared by the distance of triangles and by the tests that reject distant triangles.
#pragma once

#include "orientation.hpp"

namespace flashbvh::detail {

/// A cross product of differences up to 2^17: three components within +-2^35.
struct LongVector {
  int64_t x;
  int64_t y;
  int64_t z;
};

inline Vector negated(const Vector& v) {
  return {-v.x, -v.y, -v.z};
}

/// The vector from corner i to the next corner.
inline Vector edge_of(const Triangle& t, unsigned i) {
  return difference(t.corner[next(i)], t.corner[i]);
}

/// Range of a triangle's coordinates along one axis.
struct Range {
  int32_t least;
  int32_t most;
};

inline Range range_of(const Triangle& t, int32_t Point::*axis) {
  const int32_t p = t.corner[0].*axis;
  const int32_t q = t.corner[1].*axis;
  const int32_t r = t.corner[2].*axis;
  const int32_t least = p < q ? p : q;
  const int32_t most = p < q ? q : p;
  return {r < least ? r : least, r > most ? r : most};
}

}  // namespace flashbvh::detail
