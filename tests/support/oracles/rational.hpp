// Distances and first common points in exact rationals, by other methods than the library's.
#pragma once

#include <gmpxx.h>

#include "flashbvh/ray.hpp"
#include "support/vectors.hpp"

namespace flashbvh::test {

/// The first point of a segment on a triangle: each condition on the parameter along the segment is
/// linear, and cuts its interval.
class SegmentOracle {
 public:
  SegmentOracle(const Segment& segment, const Triangle& t)
      : from_(vector(segment.from)), way_(minus(vector(segment.to), from_)) {
    const Vector p = vector(t.corner[0]);
    const Vector u = minus(vector(t.corner[1]), p);
    const Vector v = minus(vector(t.corner[2]), p);
    const Vector n = cross(u, v);
    if (dot(n, n) != 0) {
      on_plane(n, p);
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector corner = vector(t.corner[i]);
        not_below(cross(n, minus(vector(t.corner[(i + 1) % 3]), corner)), corner);
      }
    } else {
      on_longest_edge(t);
    }
  }

  /// Whether there is a common point.
  bool meets() const { return first_ <= last_; }
  const mpq_class& first() const { return first_; }

 private:
  using Vector = test::Vector<mpz_class>;

  static Vector vector(const Point& p) { return vector_of<mpz_class>(p); }

  /// Adds the condition n . (x - p) >= 0.
  void not_below(const Vector& n, const Vector& p) {
    const mpz_class start = dot(n, minus(from_, p));
    const mpz_class slope = dot(n, way_);
    if (slope == 0) {
      if (start < 0) {
        last_ = -1;
      }
      return;
    }
    mpq_class at(-start, slope);
    at.canonicalize();
    if (slope > 0 && at > first_) {
      first_ = at;
    }
    if (slope < 0 && at < last_) {
      last_ = at;
    }
  }
  void on_plane(const Vector& n, const Vector& p) {
    not_below(n, p);
    not_below({-n[0], -n[1], -n[2]}, p);
  }

  /// Adds the conditions of a triangle without area: the point is on its longest edge.
  void on_longest_edge(const Triangle& t) {
    Vector p = vector(t.corner[0]);
    Vector edge = {0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector start = vector(t.corner[i]);
      const Vector way = minus(vector(t.corner[(i + 1) % 3]), start);
      if (dot(way, way) > dot(edge, edge)) {
        p = start;
        edge = way;
      }
    }
    const Vector axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Vector& axis : axes) {
      const Vector n = cross(edge, axis);
      on_plane(n, p);
      if (dot(edge, edge) == 0) {
        on_plane(axis, p);
      }
    }
    const Vector end = {p[0] + edge[0], p[1] + edge[1], p[2] + edge[2]};
    not_below(edge, p);
    not_below({-edge[0], -edge[1], -edge[2]}, end);
  }

  Vector from_;
  Vector way_;
  mpq_class first_ = 0;
  mpq_class last_ = 1;
};

using RationalVector = Vector<mpq_class>;

/// The distance of two triangles: the point nearest to 0 in the hull of the nine differences of
/// their corners.
///
/// A point w of the hull is nearest if and only if w . p >= w . w for each difference p. Unless the
/// hull contains 0, it is a combination of at most three differences. All sets of up to three are
/// tried, and the result is certified. If no point is nearest, the triangles intersect.
class Differences {
 public:
  Differences(const Triangle& a, const Triangle& b) {
    for (std::size_t i = 0; i < 9; ++i) {
      points_[i] =
          minus(vector_of<mpq_class>(b.corner[i % 3]), vector_of<mpq_class>(a.corner[i / 3]));
    }
  }

  /// The squared distance; 0 if the triangles intersect.
  mpq_class squared_distance() const {
    for (std::size_t i = 0; i < 9; ++i) {
      if (is_nearest(points_[i])) {
        return dot(points_[i], points_[i]);
      }
      for (std::size_t j = i + 1; j < 9; ++j) {
        RationalVector at;
        if (nearest_on_line(points_[i], points_[j], at) && is_nearest(at)) {
          return dot(at, at);
        }
        for (std::size_t k = j + 1; k < 9; ++k) {
          if (nearest_on_plane(points_[i], points_[j], points_[k], at) && is_nearest(at)) {
            return dot(at, at);
          }
        }
      }
    }
    return 0;
  }

 private:
  bool is_nearest(const RationalVector& w) const {
    const mpq_class squared = dot(w, w);
    if (squared == 0) {
      return false;
    }
    for (const RationalVector& point : points_) {
      if (dot(w, point) < squared) {
        return false;
      }
    }
    return true;
  }

  static bool nearest_on_line(const RationalVector& p, const RationalVector& q,
                              RationalVector& at) {
    const RationalVector along = minus(q, p);
    const mpq_class length = dot(along, along);
    if (length == 0) {
      return false;
    }
    const mpq_class share = -dot(p, along) / length;
    at = plus(p, share, along);
    return share >= 0 && share <= 1;
  }

  static bool nearest_on_plane(const RationalVector& p, const RationalVector& q,
                               const RationalVector& r, RationalVector& at) {
    const RationalVector u = minus(q, p);
    const RationalVector v = minus(r, p);
    const mpq_class uu = dot(u, u);
    const mpq_class uv = dot(u, v);
    const mpq_class vv = dot(v, v);
    const mpq_class area = uu * vv - uv * uv;
    if (area == 0) {
      return false;
    }
    const mpq_class s = (uv * dot(p, v) - vv * dot(p, u)) / area;
    const mpq_class t = (uv * dot(p, u) - uu * dot(p, v)) / area;
    at = plus(plus(p, s, u), t, v);
    return s >= 0 && t >= 0 && s + t <= 1;
  }

  std::array<RationalVector, 9> points_;
};

}  // namespace flashbvh::test
