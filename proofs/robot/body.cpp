#include "body.hpp"

#include <numeric>

namespace robot_check {
namespace {

double along(const Vec& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

double middle(const Triangle& t, int axis) {
  return along(t[0], axis) + along(t[1], axis) + along(t[2], axis);
}

double gap(const Vec& apart, const Vec& half) {
  return length({std::max(0.0, std::fabs(apart.x) - half.x),
                 std::max(0.0, std::fabs(apart.y) - half.y),
                 std::max(0.0, std::fabs(apart.z) - half.z)});
}

}  // namespace

Body::Body(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
  if (!triangles_.empty()) {
    nodes_.reserve(2 * triangles_.size());
    build(0, triangles_.size());
  }
}

/// Halves at the median of the box's longest side.
void Body::build(std::size_t first, std::size_t count) {
  Vec low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Vec high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = first; i < first + count; ++i) {
    for (const Vec& v : triangles_[i]) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
  }
  Node node{0.5 * (low + high),
            0.5 * (high - low),
            0,
            static_cast<std::uint32_t>(first),
            static_cast<std::uint32_t>(count),
            0};
  for (std::size_t i = first; i < first + count; ++i) {
    for (const Vec& v : triangles_[i]) {
      node.radius = std::max(node.radius, length(v - node.centre));
    }
  }
  const std::size_t number = nodes_.size();
  nodes_.push_back(node);
  if (count == 1) {
    return;
  }
  const Vec& h = node.half;
  const int axis = h.x >= h.y && h.x >= h.z ? 0 : h.y >= h.z ? 1 : 2;
  const auto begin = triangles_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto half = static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(
      begin, begin + half, begin + static_cast<std::ptrdiff_t>(count),
      [&](const Triangle& p, const Triangle& q) { return middle(p, axis) < middle(q, axis); });
  build(first, count / 2);
  nodes_[number].right = static_cast<std::uint32_t>(nodes_.size());
  build(first + count / 2, count - count / 2);
}

double Body::distance(const Vec& point, double most) const {
  double least = most;
  std::vector<std::uint32_t> waiting = {0};
  while (!waiting.empty()) {
    const std::uint32_t number = waiting.back();
    const Node& node = nodes_[number];
    waiting.pop_back();
    if (gap(point - node.centre, node.half) >= least) {
      continue;
    }
    if (node.count == 1) {
      least = std::min(least, robot_check::distance(point, triangles_[node.first]));
    } else {
      waiting.push_back(node.right);
      waiting.push_back(number + 1);
    }
  }
  return least;
}

}  // namespace robot_check
