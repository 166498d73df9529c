#include "report/view.hpp"

#include <algorithm>
#include <utility>

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

/// What points take up along a direction.
Range range_along(const Vector& direction, const std::vector<LatticePoint>& points) {
  Range range = {INT64_MAX, INT64_MIN};
  for (const LatticePoint& point : points) {
    const std::int64_t place = dot(direction, point);
    range = {std::min(range.low, place), std::max(range.high, place)};
  }
  return range;
}

}  // namespace

std::int64_t dot(const Vector& u, const Vector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

std::vector<LatticePoint> Bounds::corners() const {
  std::vector<LatticePoint> points(8, lower);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      points[corner][axis] = (corner >> axis & 1) != 0 ? upper[axis] : lower[axis];
    }
  }
  return points;
}

Bounds bounds_of(const std::vector<LatticePoint>& points) {
  Bounds bounds = {points[0], points[0]};
  for (const LatticePoint& point : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.lower[axis] = std::min(bounds.lower[axis], point[axis]);
      bounds.upper[axis] = std::max(bounds.upper[axis], point[axis]);
    }
  }
  return bounds;
}

const std::array<View, 4>& corner_views() {
  // 1,024 times 1 / sqrt(2), 1 / sqrt(6), 2 / sqrt(6) and 1 / sqrt(3).
  static const std::array<View, 4> all = {
      {{"From a corner", {724, 724, 0}, {-418, 418, 836}, {591, -591, 591}},
       {"From a corner", {-724, 724, 0}, {-418, -418, 836}, {591, 591, 591}},
       {"From a corner", {-724, -724, 0}, {418, -418, 836}, {-591, 591, 591}},
       {"From a corner", {724, -724, 0}, {418, 418, 836}, {-591, -591, 591}}}};
  return all;
}

const std::array<View, 4>& views() {
  static const std::array<View, 4> all = {
      {corner_views()[0],
       {"From above", {1024, 0, 0}, {0, 1024, 0}, {0, 0, 1024}},
       {"From the front", {1024, 0, 0}, {0, 0, 1024}, {0, -1024, 0}},
       {"From the right", {0, 1024, 0}, {0, 0, 1024}, {1024, 0, 0}}}};
  return all;
}

Frame frame_of(std::vector<LatticePoint> points, const std::array<View, 4>& views) {
  std::int64_t extent = View::kUnit;
  for (const View& view : views) {
    for (const Vector& direction : {view.right, view.up}) {
      const Range range = range_along(direction, points);
      extent = std::max(extent, range.high - range.low);
    }
  }
  return {std::move(points), extent * 33 / 32 / View::kUnit + 1};
}

Projection::Projection(const View& view, const Frame& frame, std::int64_t side)
    : view_(view),
      origin_(frame.points[0]),
      side_(side),
      extent_(View::kUnit * frame.across),
      left_(0),
      top_(0) {
  const Range x = range_along(view.right, frame.points);
  const Range y = range_along(view.up, frame.points);
  const std::int64_t middle_x = (x.low + x.high) / 2 - dot(view.right, origin_);
  const std::int64_t middle_y = (y.low + y.high) / 2 - dot(view.up, origin_);
  left_ = side / 2 - rounded_quotient(middle_x * side, extent_);
  top_ = side / 2 + rounded_quotient(middle_y * side, extent_);
}

Projected Projection::project(const LatticePoint& point) const {
  const Projected way =
      rotate({point[0] - origin_[0], point[1] - origin_[1], point[2] - origin_[2]});
  return {left_ + way.x, top_ + way.y, way.depth};
}

Projected Projection::rotate(const Vector& direction) const {
  return {rounded_quotient(dot(view_.right, direction) * side_, extent_),
          rounded_quotient(-dot(view_.up, direction) * side_, extent_),
          -dot(view_.towards, direction)};
}

}  // namespace flashbvh::tool
