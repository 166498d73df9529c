// The oracle for contacts: all corners of two triangles' intersection, as exact rationals.
//
// A corner of the intersection of any two closed triangles is a corner of one, a point where an
// edge of one crosses the plane of the other, or a crossing of two edges. The oracle tries all of
// these, 6 + 6 + 9, and keeps those in both triangles, tested one by one. It needs no case for
// coplanar or degenerate input, no intervals, no order, no rounding.
//
// Range: corners within 114,000 < 2^17 of the first one, which holds for triangles that intersect.
// A point has numerators below 2^71 over a denominator below 2^53; a normal is below 2^33.
#pragma once

#include <vector>

#include "flashbvh/contact.hpp"
#include "support/oracles/triangle.hpp"
#include "support/vectors.hpp"

namespace flashbvh::test {

using WideVector = Vector<Wide>;

/// A point relative to the first corner of the first triangle: at[] / by, by > 0.
struct Rational {
  WideVector at;
  Wide by;
};

/// A triangle's corners relative to the first corner of the first triangle.
struct WideTriangle {
  WideVector corner[3];

  WideTriangle(const Triangle& t, const Point& origin) {
    for (int i = 0; i < 3; ++i) {
      corner[i] = minus(vector_of<Wide>(t.corner[i]), vector_of<Wide>(origin));
    }
  }
  WideVector edge(int i) const { return minus(corner[(i + 1) % 3], corner[i]); }
  WideVector normal() const { return cross(edge(0), minus(corner[2], corner[0])); }
};

/// p + (q - p) * part / whole, for `whole` of either sign, but not 0.
inline Rational point_between(const WideVector& p, const WideVector& q, Wide part, Wide whole) {
  const Wide sign = whole < 0 ? -1 : 1;
  return {plus(times(sign * whole, p), sign * part, minus(q, p)), sign * whole};
}

/// Whether p lies on the closed segment s, e, which may be a point.
inline bool on_segment(const Rational& p, const WideVector& s, const WideVector& e) {
  const WideVector from_s = minus(p.at, times(p.by, s));
  const WideVector whole = minus(e, s);
  const Wide share = dot(from_s, whole);
  return cross(from_s, whole) == WideVector{} && share >= 0 && share <= p.by * dot(whole, whole) &&
         (whole != WideVector{} || from_s == WideVector{});
}

/// Whether p lies in the closed triangle t, which may be a segment or a point.
inline bool in_triangle(const Rational& p, const WideTriangle& t) {
  const WideVector normal = t.normal();
  if (normal == WideVector{}) {
    return on_segment(p, t.corner[0], t.corner[1]) || on_segment(p, t.corner[1], t.corner[2]) ||
           on_segment(p, t.corner[2], t.corner[0]);
  }
  bool inside = dot(normal, minus(p.at, times(p.by, t.corner[0]))) == 0;
  for (int i = 0; inside && i < 3; ++i) {
    const WideVector from = minus(p.at, times(p.by, t.corner[i]));
    inside = dot(normal, cross(t.edge(i), from)) >= 0;
  }
  return inside;
}

/// Adds the point where edge i of `a` crosses the plane of `b`.
inline void add_plane_crossing(const WideTriangle& a, int i, const WideTriangle& b,
                               std::vector<Rational>& points) {
  const WideVector normal = b.normal();
  const Wide part = dot(normal, minus(b.corner[0], a.corner[i]));
  const Wide whole = dot(normal, a.edge(i));
  if (whole != 0) {
    points.push_back(point_between(a.corner[i], a.corner[(i + 1) % 3], part, whole));
  }
}

/// Adds the point where the lines of edge i of `a` and edge j of `b` cross in some projection.
inline void add_edge_crossing(const WideTriangle& a, int i, const WideTriangle& b, int j,
                              std::vector<Rational>& points) {
  const WideVector whole = cross(a.edge(i), b.edge(j));
  const WideVector part = cross(minus(b.corner[j], a.corner[i]), b.edge(j));
  for (std::size_t k = 0; k < 3; ++k) {
    if (whole[k] != 0) {
      points.push_back(point_between(a.corner[i], a.corner[(i + 1) % 3], part[k], whole[k]));
      return;
    }
  }
}

inline bool is_between_ends(const Rational& p, const WideTriangle& a, int i) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Wide s = a.corner[i][k] * p.by;
    const Wide e = a.corner[(i + 1) % 3][k] * p.by;
    if ((p.at[k] < s && p.at[k] < e) || (p.at[k] > s && p.at[k] > e)) {
      return false;
    }
  }
  return true;
}

/// Adds all points on edge i of `a` that may be corners of the intersection.
inline void add_on_edge(const WideTriangle& a, int i, const WideTriangle& b,
                        std::vector<Rational>& points) {
  std::vector<Rational> tried = {{a.corner[i], 1}};
  add_plane_crossing(a, i, b, tried);
  for (int j = 0; j < 3; ++j) {
    add_edge_crossing(a, i, b, j, tried);
  }
  for (const Rational& p : tried) {
    // The tests below could overflow for points far outside.
    if (is_between_ends(p, a, i) && in_triangle(p, a) && in_triangle(p, b)) {
      points.push_back(p);
    }
  }
}

/// Points whose convex hull is the intersection; some may be equal, or no corners.
inline std::vector<Rational> common_corners(const Triangle& a, const Triangle& b) {
  const WideTriangle wide_a(a, a.corner[0]);
  const WideTriangle wide_b(b, a.corner[0]);
  std::vector<Rational> points;
  for (int i = 0; i < 3; ++i) {
    add_on_edge(wide_a, i, wide_b, points);
    add_on_edge(wide_b, i, wide_a, points);
  }
  return points;
}

}  // namespace flashbvh::test
