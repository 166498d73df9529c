#include "report/view.hpp"

#include <algorithm>

namespace flashbvh::tool {
namespace {

/// To the nearest; `divisor` is positive.
std::int64_t rounded_quotient(std::int64_t value, std::int64_t divisor) {
  const std::int64_t twice = 2 * value + divisor;
  const std::int64_t quotient = twice / (2 * divisor);
  return twice < 0 && twice % (2 * divisor) != 0 ? quotient - 1 : quotient;
}

struct Range {
  std::int64_t low;
  std::int64_t high;
};

/// What the box takes up along a direction.
Range range_along(const Vector& direction, const detail::Box& box) {
  const std::array<Range, 3> sides = {
      {{box.lower.x, box.upper.x}, {box.lower.y, box.upper.y}, {box.lower.z, box.upper.z}}};
  Range range = {0, 0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t p = direction[axis] * sides[axis].low;
    const std::int64_t q = direction[axis] * sides[axis].high;
    range.low += std::min(p, q);
    range.high += std::max(p, q);
  }
  return range;
}

}  // namespace

std::int64_t dot(const Vector& u, const Vector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

const std::array<View, 4>& views() {
  // 1,024 times 1 / sqrt(2), 1 / sqrt(6), 2 / sqrt(6) and 1 / sqrt(3).
  static const std::array<View, 4> all = {
      {{"From a corner",
        "z up, x to the front right, y to the back right",
        {724, 724, 0},
        {-418, 418, 836},
        {591, -591, 591}},
       {"From above", "x to the right, y up", {1024, 0, 0}, {0, 1024, 0}, {0, 0, 1024}},
       {"From the front", "x to the right, z up", {1024, 0, 0}, {0, 0, 1024}, {0, -1024, 0}},
       {"From the right", "y to the right, z up", {0, 1024, 0}, {0, 0, 1024}, {1024, 0, 0}}}};
  return all;
}

Projection::Projection(const View& view, const detail::Box& box, std::int64_t side,
                       std::int64_t margin)
    : view_(view), side_(side), room_(side - 2 * margin) {
  const Range x = range_along(view.right, box);
  const Range y = range_along(view.up, box);
  extent_ = std::max<std::int64_t>({x.high - x.low, y.high - y.low, 1});
  middle_x_ = x.low + x.high;
  middle_y_ = y.low + y.high;
}

Projected Projection::project(const Vertex& vertex) const {
  const Vector v = {vertex.x, vertex.y, vertex.z};
  return {
      rounded_quotient((2 * dot(view_.right, v) - middle_x_) * room_ + side_ * extent_,
                       2 * extent_),
      rounded_quotient((middle_y_ - 2 * dot(view_.up, v)) * room_ + side_ * extent_, 2 * extent_),
      -dot(view_.towards, v)};
}

Projected Projection::rotate(const Vector& direction) const {
  return {rounded_quotient(dot(view_.right, direction) * room_, extent_),
          rounded_quotient(-dot(view_.up, direction) * room_, extent_),
          -dot(view_.towards, direction)};
}

}  // namespace flashbvh::tool
