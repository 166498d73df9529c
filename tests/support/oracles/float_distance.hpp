// The distance of any two triangles in doubles: the least over their features, or 0 where an edge
// pierces a face; and of a point from a triangle. Uses other methods than the library.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "support/vectors.hpp"

namespace flashbvh::test {

using FloatTriangle = std::array<FloatVector, 3>;

inline double squared(const FloatVector& u) {
  return dot(u, u);
}

/// A face, which may have no area.
class FloatFace {
 public:
  explicit FloatFace(const FloatTriangle& t)
      : corner_(t), normal_(cross(minus(t[1], t[0]), minus(t[2], t[0]))), area_(squared(normal_)) {}

  /// The squared distance of p; infinite if p does not project into the face.
  double distance(const FloatVector& p) const {
    const double above = height(p);
    return is_over(p) ? above * above / area_ : std::numeric_limits<double>::infinity();
  }
  bool is_pierced(const FloatVector& p, const FloatVector& q) const {
    const double from = height(p);
    const double to = height(q);
    return from * to < 0 && is_over(plus(p, from / (from - to), minus(q, p)));
  }

 private:
  double height(const FloatVector& p) const { return dot(normal_, minus(p, corner_[0])); }
  bool is_over(const FloatVector& p) const {
    bool inside = area_ > 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const FloatVector edge = minus(corner_[(i + 1) % 3], corner_[i]);
      inside = inside && dot(normal_, cross(edge, minus(p, corner_[i]))) >= 0;
    }
    return inside;
  }

  FloatTriangle corner_;
  FloatVector normal_;
  double area_;
};

inline double distance_to_edge(const FloatVector& p, const FloatVector& s, const FloatVector& e) {
  const FloatVector edge = minus(e, s);
  const double length = squared(edge);
  const double share = length > 0 ? dot(minus(p, s), edge) / length : 0;
  return squared(minus(p, plus(s, std::clamp(share, 0.0, 1.0), edge)));
}

/// The squared distance of two edges' lines; infinite if the nearest points lie off an edge.
inline double distance_across(const FloatVector& p, const FloatVector& p_end, const FloatVector& q,
                              const FloatVector& q_end) {
  const FloatVector u = minus(p_end, p);
  const FloatVector v = minus(q_end, q);
  const FloatVector from = minus(p, q);
  const double area = squared(cross(u, v));
  const double s = (dot(u, v) * dot(v, from) - squared(v) * dot(u, from)) / area;
  const double t = (squared(u) * dot(v, from) - dot(u, v) * dot(u, from)) / area;
  const bool crosses = area > 0 && s >= 0 && s <= 1 && t >= 0 && t <= 1;
  return crosses ? squared(plus(plus(from, s, u), -t, v)) : std::numeric_limits<double>::infinity();
}

inline double squared_distance(const FloatVector& p, const FloatTriangle& t) {
  return std::min({FloatFace(t).distance(p), distance_to_edge(p, t[0], t[1]),
                   distance_to_edge(p, t[1], t[2]), distance_to_edge(p, t[2], t[0])});
}

inline double squared_distance(const FloatTriangle& a, const FloatTriangle& b) {
  const FloatFace face_a(a);
  const FloatFace face_b(b);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    if (face_b.is_pierced(a[i], a[k]) || face_a.is_pierced(b[i], b[k])) {
      return 0;
    }
    least = std::min({least, face_b.distance(a[i]), face_a.distance(b[i])});
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t l = (j + 1) % 3;
      least =
          std::min({least, distance_to_edge(a[i], b[j], b[l]), distance_to_edge(b[i], a[j], a[l]),
                    distance_across(a[i], a[k], b[j], b[l])});
    }
  }
  return least;
}

}  // namespace flashbvh::test
