#include "report/view.hpp"

#include <algorithm>

#include "text/numbers.hpp"

namespace flashbvh::tool {

std::int64_t dot(const Vector& u, const Vector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

std::int64_t square_root(std::int64_t value) {
  std::int64_t root = 0;  // below 2^31
  for (std::int64_t bit = std::int64_t{1} << 30; bit != 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) {
      root += bit;
    }
  }
  return root;
}

Vector difference(const Vector& u, const Vector& v) {
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}

const std::array<View, 4>& views() {
  // 1,024 times 1 / sqrt(2), 1 / sqrt(6), 2 / sqrt(6) and 1 / sqrt(3).
  static const std::array<View, 4> all = {
      {{"From a corner", {724, 724, 0}, {-418, 418, 836}, {591, -591, 591}},
       {"From above", {1024, 0, 0}, {0, 1024, 0}, {0, 0, 1024}},
       {"From the front", {1024, 0, 0}, {0, 0, 1024}, {0, -1024, 0}},
       {"From the right", {0, 1024, 0}, {0, 0, 1024}, {1024, 0, 0}}}};
  return all;
}

Frame::Frame(const View& seen_from, const std::vector<LatticePoint>& points)
    : view(seen_from), middle(), across(1) {
  const std::array<const Vector*, 3> directions = {&view.right, &view.up, &view.towards};
  for (std::size_t i = 0; i < 3; ++i) {
    std::int64_t low = INT64_MAX;
    std::int64_t high = INT64_MIN;
    for (const LatticePoint& point : points) {
      const std::int64_t along = dot(*directions[i], point);
      low = std::min(low, along);
      high = std::max(high, along);
    }
    middle[i] = low + (high - low) / 2;
    if (i < 2) {
      across = std::max(across, (high - low) * 33 / 32 / View::kUnit + 1);  // room for lines
    }
  }
}

Vector Frame::project(const LatticePoint& point) const {
  const auto along = [&](const Vector& direction, std::size_t i) {
    return (dot(direction, point) - middle[i]) * kDrawingSide / (across * View::kUnit);
  };
  return {kDrawingSide / 2 + along(view.right, 0), kDrawingSide / 2 - along(view.up, 1),
          -along(view.towards, 2)};
}

std::string step(const Vector& from, const Vector& to) {
  return concat(to[0] - from[0], (to[1] < from[1] ? "" : " "), to[1] - from[1]);
}

}  // namespace flashbvh::tool
