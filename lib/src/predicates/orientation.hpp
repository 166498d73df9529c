// Exact orientation predicates: only differences of corners are multiplied, so their position never
// matters. Each value is exact within the ranges that the callers state.
#pragma once

#include "flashbvh/lattice.hpp"

namespace flashbvh::detail {

/// A vector in cells.
struct Vector {
  int32_t x;
  int32_t y;
  int32_t z;
};

inline Vector difference(const Point& to, const Point& from) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

/// A cross product u x v. Cofactors: a vector of int32_t or int64_t that holds its components,
/// which are sums of two products of differences.
template <class Cofactors>
inline Cofactors cross(const Vector& u, const Vector& v) {
  const Cofactors wide = {u.x, u.y, u.z};
  return {wide.y * v.z - wide.z * v.y, wide.z * v.x - wide.x * v.z, wide.x * v.y - wide.y * v.x};
}

template <class Cofactors>
inline int64_t dot(const Cofactors& n, const Vector& v) {
  return static_cast<int64_t>(n.x) * v.x + static_cast<int64_t>(n.y) * v.y +
         static_cast<int64_t>(n.z) * v.z;
}

/// The normal of a triangle; its length is twice the area.
template <class Cofactors>
inline Cofactors normal_of(const Triangle& t) {
  return cross<Cofactors>(difference(t.corner[1], t.corner[0]),
                          difference(t.corner[2], t.corner[0]));
}

/// Six times the signed volume of the tetrahedron p, q, r, s. Cofactors: of its edges p-q and r-s.
template <class Cofactors>
[[gnu::noinline]] int64_t volume(const Point& p, const Point& q, const Point& r, const Point& s) {
  return dot(cross<Cofactors>(difference(s, r), difference(q, p)), difference(r, p));
}

/// Twice the signed area of p, q, r in the projection onto the axes u and v; positive if they turn
/// left.
inline int64_t area(int32_t Point::*u, int32_t Point::*v, const Point& p, const Point& q,
                    const Point& r) {
  return static_cast<int64_t>(q.*u - p.*u) * (r.*v - p.*v) -
         static_cast<int64_t>(q.*v - p.*v) * (r.*u - p.*u);
}

constexpr unsigned kAllCorners = 7;

/// The sides of a plane on which a triangle's corners lie: bit i if corner i is strictly above, bit
/// 3 + i if it is strictly below.
struct Sides {
  unsigned bits;

  unsigned above() const { return bits & kAllCorners; }
  unsigned below() const { return bits >> 3; }
  bool separate() const { return above() == kAllCorners || below() == kAllCorners; }
  bool all_on_plane() const { return bits == 0; }
};

/// `height(corner)`: above the plane, in any unit.
template <class Height>
inline Sides sides_of(const Triangle& tested, const Height& height) {
  const auto bits = [&](const Point& corner, unsigned above) {
    const int64_t at = height(corner);
    return at > 0 ? above : at < 0 ? above << 3 : 0u;
  };
  return {bits(tested.corner[0], 1) | bits(tested.corner[1], 2) | bits(tested.corner[2], 4)};
}

/// The corner alone on its side of a plane that the triangle crosses or touches. Both edges from it
/// end strictly on the other side or, unless it is itself on the plane, on the plane: each edge
/// intersects the plane in exactly one point.
struct Tip {
  unsigned corner;
  bool up;
};

inline Tip tip_of(Sides sides) {
  // Corners above the others: never none and never all, since neither side has all three.
  const unsigned upper = sides.above() != 0 ? sides.above() : kAllCorners ^ sides.below();
  const bool one = (upper & (upper - 1)) == 0;
  return {(one ? upper : kAllCorners ^ upper) >> 1, one};
}

inline unsigned next(unsigned corner) {
  return corner == 2 ? 0 : corner + 1;
}
inline unsigned previous(unsigned corner) {
  return corner == 0 ? 2 : corner - 1;
}

}  // namespace flashbvh::detail
