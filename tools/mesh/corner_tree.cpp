#include "mesh/corner_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace flashbvh::tool {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The largest turn from the edge p q to a point of the box.
double largest_turn(const Corner2& p, const Corner2& q, const Corner2& low, const Corner2& high) {
  return turn(p, q, {q[1] > p[1] ? low[0] : high[0], q[0] > p[0] ? high[1] : low[1]});
}

bool may_reach(const Triangle2& triangle, const Corner2& low, const Corner2& high) {
  return largest_turn(triangle[0], triangle[1], low, high) >= 0 &&
         largest_turn(triangle[1], triangle[2], low, high) >= 0 &&
         largest_turn(triangle[2], triangle[0], low, high) >= 0;
}

}  // namespace

CornerTree::CornerTree(const std::vector<Corner2>& corners)
    : count_(static_cast<std::uint32_t>(corners.size())) {
  while (leaves_ < count_) {
    leaves_ *= 2;
  }
  boxes_.assign(2 * std::size_t{leaves_}, {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}});
  for (std::uint32_t i = 0; i < count_; ++i) {
    boxes_[leaves_ + i] = {corners[i], corners[i]};
  }
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    join_children(node);
  }
}

void CornerTree::remove(std::uint32_t corner) {
  std::size_t node = std::size_t{leaves_} + corner;
  boxes_[node] = {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (node /= 2; node > 0; node /= 2) {
    join_children(node);
  }
}

std::uint32_t CornerTree::first_inside(const Triangle2& triangle, std::uint32_t begin) const {
  return search(triangle, begin, 1, 0, leaves_);
}

std::uint32_t CornerTree::search(const Triangle2& triangle, std::uint32_t begin, std::size_t node,
                                 std::uint32_t first, std::uint32_t width) const {
  const auto& [low, high] = boxes_[node];
  if (first + width <= begin || low[0] > high[0] || !may_reach(triangle, low, high)) {
    return count_;
  }
  if (width == 1) {
    const bool is_own = low == triangle[0] || low == triangle[1] || low == triangle[2];
    return is_own ? count_ : first;
  }
  const std::uint32_t found = search(triangle, begin, 2 * node, first, width / 2);
  return found != count_ ? found
                         : search(triangle, begin, 2 * node + 1, first + width / 2, width / 2);
}

void CornerTree::join_children(std::size_t node) {
  const Box& left = boxes_[2 * node];
  const Box& right = boxes_[2 * node + 1];
  for (std::size_t axis = 0; axis < 2; ++axis) {
    boxes_[node].low[axis] = std::min(left.low[axis], right.low[axis]);
    boxes_[node].high[axis] = std::max(left.high[axis], right.high[axis]);
  }
}

}  // namespace flashbvh::tool
