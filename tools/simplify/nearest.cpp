#include "simplify/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace flashbvh::simplify {
namespace {

constexpr std::uint32_t kLeafSize = 4;
/// More than the depth of any tree of halves.
constexpr std::size_t kStackSize = 64;
/// A triangle is thin if its area, squared, is below this part of its sides': doubles leave few
/// correct digits of it, so its edges are tested, too.
constexpr double kThin = 0x1p-40;

Point between(const Point& p, const Point& q, double part) {
  return {p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1]), p[2] + part * (q[2] - p[2])};
}

/// The squared distance from the origin to a segment.
double squared_to_segment(const Point& from, const Point& vector) {
  const double length = dot(vector, vector);
  const double along = length > 0 ? std::clamp(-dot(from, vector) / length, 0.0, 1.0) : 0;
  const Point at = {from[0] + along * vector[0], from[1] + along * vector[1],
                    from[2] + along * vector[2]};
  return dot(at, at);
}

double centre(const PointTriangle& triangle, std::size_t axis) {
  return triangle[0][axis] + triangle[1][axis] + triangle[2][axis];
}

/// Cuts at the plane above which the corners have these heights; one corner is alone on its side.
std::vector<PointTriangle> cut_at_plane(const PointTriangle& part,
                                        const std::array<double, 3>& heights) {
  std::size_t alone = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_above = heights[i] > 0;
    if (is_above != (heights[(i + 1) % 3] > 0) && is_above != (heights[(i + 2) % 3] > 0)) {
      alone = i;
    }
  }
  const std::size_t next = (alone + 1) % 3;
  const std::size_t last = (alone + 2) % 3;
  const auto crossing = [&](std::size_t other) {
    return between(part[alone], part[other], heights[alone] / (heights[alone] - heights[other]));
  };
  const Point to_next = crossing(next);
  const Point to_last = crossing(last);
  return {{part[alone], to_next, to_last},
          {to_next, part[next], part[last]},
          {to_next, part[last], to_last}};
}

}  // namespace

Point minus(const Point& p, const Point& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

Point cross(const Point& u, const Point& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double dot(const Point& u, const Point& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

void Box::add(const Point& p) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = std::min(low[axis], p[axis]);
    high[axis] = std::max(high[axis], p[axis]);
  }
}

double Box::squared_distance(const Point& p) const {
  double squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double out = std::max({low[axis] - p[axis], p[axis] - high[axis], 0.0});
    squared += out * out;
  }
  return squared;
}

std::array<PointTriangle, 4> quarters_of(const PointTriangle& triangle) {
  const auto& [a, b, c] = triangle;
  const Point ab = between(a, b, 0.5);
  const Point bc = between(b, c, 0.5);
  const Point ca = between(c, a, 0.5);
  return {{{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {bc, ca, ab}}};
}

Point centre_of(const PointTriangle& triangle) {
  Point sum = triangle[0];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum[axis] = (sum[axis] + triangle[1][axis] + triangle[2][axis]) / 3;
  }
  return sum;
}

double radius_of(const PointTriangle& triangle, const Point& centre) {
  double squared = 0;
  for (const Point& corner : triangle) {
    const Point off = minus(corner, centre);
    squared = std::max(squared, dot(off, off));
  }
  return std::sqrt(squared);
}

std::vector<PointTriangle> cut(const PointTriangle& part, const PointTriangle& triangle,
                               double least) {
  const Point normal = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
  double most = least;
  std::array<double, 3> beyond{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& from = triangle[i];
    Point outwards = cross(minus(triangle[(i + 1) % 3], from), normal);
    const double length = std::sqrt(dot(outwards, outwards));
    std::array<double, 3> heights{};
    for (std::size_t k = 0; k < 3 && length > 0; ++k) {
      heights[k] = dot(minus(part[k], from), outwards) / length;
    }
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    if (*low<-least&& * high> most) {
      most = *high;
      beyond = heights;
    }
  }
  if (most > least) {
    return cut_at_plane(part, beyond);
  }
  const std::array<PointTriangle, 4> quarters = quarters_of(part);
  return {quarters.begin(), quarters.end()};
}

double squared_distance(const Point& p, const PointTriangle& triangle) {
  const Point a = minus(triangle[0], p);
  const Point u = minus(triangle[1], triangle[0]);
  const Point v = minus(triangle[2], triangle[0]);
  const double uu = dot(u, u);
  const double uv = dot(u, v);
  const double vv = dot(v, v);
  const double au = dot(a, u);
  const double av = dot(a, v);
  const double area = uu * vv - uv * uv;
  const double s = uv * av - vv * au;
  const double t = uv * au - uu * av;
  const bool is_thin = !(area > kThin * uu * vv);
  double squared = dot(a, a);
  if (area > 0 && s >= 0 && t >= 0 && s + t <= area) {
    const Point at = {a[0] + (s * u[0] + t * v[0]) / area, a[1] + (s * u[1] + t * v[1]) / area,
                      a[2] + (s * u[2] + t * v[2]) / area};
    squared = std::min(squared, dot(at, at));
    if (!is_thin) {
      return squared;
    }
  }
  // Only edges beyond which the point lies can be nearest, or the one corner between two of them.
  if (is_thin || t < 0) {
    squared = std::min(squared, squared_to_segment(a, u));
  }
  if (is_thin || s < 0) {
    squared = std::min(squared, squared_to_segment(a, v));
  }
  if (is_thin || s + t > area) {
    const Point b = minus(triangle[1], p);
    squared = std::min(squared, squared_to_segment(b, minus(triangle[2], triangle[1])));
  }
  return squared;
}

NearestTriangle::NearestTriangle(const bake::SourceMesh& mesh) {
  std::vector<PointTriangle> source;
  source.reserve(mesh.triangles.size());
  for (const bake::TriangleCorners& corners : mesh.triangles) {
    source.push_back(triangle_of(mesh, corners));
  }
  std::vector<std::uint32_t> order(source.size());
  std::iota(order.begin(), order.end(), 0U);
  triangles_.reserve(source.size());
  build(order, 0, static_cast<std::uint32_t>(source.size()), source);
  numbers_ = std::move(order);
}

void NearestTriangle::build(std::vector<std::uint32_t>& order, std::uint32_t first,
                            std::uint32_t count, const std::vector<PointTriangle>& source) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Box box;
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const Point& corner : source[order[i]]) {
      box.add(corner);
    }
  }
  nodes_.push_back({box, 0, 0});
  if (count <= kLeafSize) {
    nodes_[number].first = static_cast<std::uint32_t>(triangles_.size());
    nodes_[number].count = count;
    for (std::uint32_t i = first; i < first + count; ++i) {
      triangles_.push_back(source[order[i]]);
    }
    return;
  }
  const Point size = minus(box.high, box.low);
  const auto axis =
      static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  const auto begin = order.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(centre(source[a], axis), a) < std::pair(centre(source[b], axis), b);
  });
  build(order, first, count / 2, source);
  nodes_[number].first = static_cast<std::uint32_t>(nodes_.size());
  build(order, first + count / 2, count - count / 2, source);
}

NearestTriangle::Found NearestTriangle::to(const Point& p, std::uint32_t hint) const {
  Found found = {hint, squared_distance(p, triangles_[hint])};
  std::array<std::pair<std::uint32_t, double>, kStackSize> stack;
  std::size_t size = 0;
  stack[size++] = {0, nodes_[0].box.squared_distance(p)};
  while (size > 0) {
    const auto [number, squared] = stack[--size];
    if (squared >= found.squared) {
      continue;
    }
    const Node& node = nodes_[number];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const double to = squared_distance(p, triangles_[i]);
      found = to < found.squared ? Found{i, to} : found;
    }
    if (node.count == 0) {
      std::pair near(number + 1, nodes_[number + 1].box.squared_distance(p));
      std::pair far(node.first, nodes_[node.first].box.squared_distance(p));
      if (far.second < near.second) {
        std::swap(near, far);
      }
      stack[size++] = far;
      stack[size++] = near;
    }
  }
  return found;
}

}  // namespace flashbvh::simplify
