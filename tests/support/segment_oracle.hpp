// Where a segment first has a point of a triangle, in exact rationals, by another way than the
// library's: each condition on the place along the segment is linear, and cuts what is left of it.
#ifndef FLASHBVH_TESTS_RAY_SEGMENT_ORACLE_HPP
#define FLASHBVH_TESTS_RAY_SEGMENT_ORACLE_HPP

#include <gmpxx.h>

#include <array>

#include "flashbvh/ray.hpp"

namespace flashbvh::test {

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

  /// False: no common point.
  bool meets() const { return first_ <= last_; }
  const mpq_class& first() const { return first_; }

 private:
  using Vector = std::array<mpz_class, 3>;

  static Vector vector(const Point& p) { return {p.x, p.y, p.z}; }
  static Vector minus(const Vector& u, const Vector& v) {
    return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
  }
  static Vector cross(const Vector& u, const Vector& v) {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }
  static mpz_class dot(const Vector& u, const Vector& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  }

  /// n . (x - p) >= 0
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

  /// Of a triangle without area.
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

}  // namespace flashbvh::test

#endif
