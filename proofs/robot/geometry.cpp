#include "geometry.hpp"

namespace robot_check {
namespace {

double clamped(double value) {
  return std::clamp(value, 0.0, 1.0);
}

double segment_distance(const Vec& p, const Vec& q, const Vec& point) {
  const Vec along = q - p;
  const double squared = dot(along, along);
  const double part = squared > 0 ? clamped(dot(point - p, along) / squared) : 0;
  return length(p + part * along - point);
}

/// The distance of the lines' nearest points, if both lie within the edges; corners cover the ends.
double edge_distance(const Vec& p, const Vec& u, const Vec& r, const Vec& v) {
  const Vec w = p - r;
  const double uv = dot(u, v);
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double uw = dot(u, w);
  const double vw = dot(v, w);
  const double denominator = uu * vv - uv * uv;
  const double at_u = uv * vw - vv * uw;
  const double at_v = uu * vw - uv * uw;
  if (!(denominator > 0) || at_u < 0 || at_u > denominator || at_v < 0 || at_v > denominator) {
    return HUGE_VAL;
  }
  return length(w + at_u / denominator * u - at_v / denominator * v);
}

/// Whether a point of the triangle's plane lies in the triangle.
bool is_above(const Triangle& t, const Vec& normal, const Vec& point) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(cross(t[(i + 1) % 3] - t[i], point - t[i]), normal) < 0) {
      return false;
    }
  }
  return true;
}

bool pierces(const Vec& p, const Vec& q, const Triangle& t) {
  const Vec normal = cross(t[1] - t[0], t[2] - t[0]);
  const double from = dot(p - t[0], normal);
  const double to = dot(q - t[0], normal);
  return from != to && (from <= 0) != (to <= 0) &&
         is_above(t, normal, p + from / (from - to) * (q - p));
}

}  // namespace

double distance(const Vec& point, const Triangle& t) {
  const Vec normal = cross(t[1] - t[0], t[2] - t[0]);
  const double size = length(normal);
  if (size > 0 && is_above(t, normal, point)) {
    return std::fabs(dot(point - t[0], normal)) / size;
  }
  return std::min({segment_distance(t[0], t[1], point), segment_distance(t[1], t[2], point),
                   segment_distance(t[2], t[0], point)});
}

double distance(const Triangle& a, const Triangle& b) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    if (pierces(a[i], a[k], b) || pierces(b[i], b[k], a)) {
      return 0;
    }
    least = std::min({least, distance(a[i], b), distance(b[i], a)});
    for (std::size_t j = 0; j < 3; ++j) {
      least = std::min(least, edge_distance(a[i], a[k] - a[i], b[j], b[(j + 1) % 3] - b[j]));
    }
  }
  return least;
}

}  // namespace robot_check
