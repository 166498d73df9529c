// Vectors, frames and distances in ordinary doubles. Lengths in cells.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace robot_check {

struct Vec {
  double x = 0, y = 0, z = 0;
};

inline Vec vec_of(const std::int32_t (&v)[3]) {
  return {1.0 * v[0], 1.0 * v[1], 1.0 * v[2]};
}
inline Vec operator+(const Vec& a, const Vec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec operator-(const Vec& a, const Vec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec operator*(double s, const Vec& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec& a) {
  return std::sqrt(dot(a, a));
}

/// A frame in another frame: its axes and its origin.
struct Frame {
  std::array<Vec, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec origin;

  Vec turned(const Vec& v) const { return v.x * axes[0] + v.y * axes[1] + v.z * axes[2]; }
  Vec placed(const Vec& v) const { return turned(v) + origin; }
  Vec turned_back(const Vec& v) const {
    return {dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)};
  }
};

inline Frame operator*(const Frame& outer, const Frame& inner) {
  Frame frame;
  for (std::size_t i = 0; i < 3; ++i) {
    frame.axes[i] = outer.turned(inner.axes[i]);
  }
  frame.origin = outer.placed(inner.origin);
  return frame;
}

inline Frame inverse(const Frame& frame) {
  Frame back;
  back.axes = {frame.turned_back({1, 0, 0}), frame.turned_back({0, 1, 0}),
               frame.turned_back({0, 0, 1})};
  back.origin = -1.0 * back.turned(frame.origin);
  return back;
}

/// A rotation about z, or a translation along z.
inline Frame turn(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {{{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}}, {}};
}
inline Frame slide(double way) {
  Frame frame;
  frame.origin.z = way;
  return frame;
}

using Triangle = std::array<Vec, 3>;

/// The distance; 0 if they have a common point.
double distance(const Triangle& a, const Triangle& b);
double distance(const Vec& point, const Triangle& triangle);

}  // namespace robot_check
