// How far two triangles are apart, in exact rationals, by another way than the library's: the point
// nearest to 0 of the hull of the nine differences of their corners.
//
// A point w of the hull is that one exactly if w . p >= w . w for each of the nine. At most three
// of them are needed to make it, unless the hull holds 0; so all sets of up to three are tried, and
// what is returned is certified. No such point: the triangles intersect.
#ifndef FLASHBVH_TESTS_CLEARANCE_DISTANCE_ORACLE_HPP
#define FLASHBVH_TESTS_CLEARANCE_DISTANCE_ORACLE_HPP

#include <gmpxx.h>

#include <array>

#include "flashbvh/lattice.hpp"

namespace flashbvh::test {

using RationalVector = std::array<mpq_class, 3>;

inline mpq_class dot(const RationalVector& u, const RationalVector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

/// Of the nine differences of corners.
class Differences {
 public:
  Differences(const Triangle& a, const Triangle& b) {
    for (std::size_t i = 0; i < 9; ++i) {
      const Point& p = a.corner[i / 3];
      const Point& q = b.corner[i % 3];
      points_[i] = {mpq_class(q.x - p.x), mpq_class(q.y - p.y), mpq_class(q.z - p.z)};
    }
  }

  /// Of the hull's point nearest to 0; 0 if the triangles intersect.
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
  static RationalVector minus(const RationalVector& u, const RationalVector& v) {
    return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
  }
  static RationalVector plus(const RationalVector& u, const mpq_class& share,
                             const RationalVector& v) {
    return {u[0] + share * v[0], u[1] + share * v[1], u[2] + share * v[2]};
  }

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

#endif
