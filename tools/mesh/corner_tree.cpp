#include "mesh/corner_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

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
    : count_(static_cast<std::uint32_t>(corners.size())), corner_(count_), leaf_(count_) {
  while (leaves_ < count_) {
    leaves_ *= 2;
  }
  std::iota(corner_.begin(), corner_.end(), 0u);
  split(corners, 0, leaves_);
  boxes_.assign(2 * std::size_t{leaves_}, {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}});
  for (std::uint32_t i = 0; i < count_; ++i) {
    leaf_[corner_[i]] = i;
    boxes_[leaves_ + i] = {corners[corner_[i]], corners[corner_[i]]};
  }
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    join_children(node);
  }
}

/// Halves the leaves from `first` on, as far as they have corners, across the longer side.
void CornerTree::split(const std::vector<Corner2>& corners, std::uint32_t first,
                       std::uint32_t width) {
  const std::uint32_t middle = first + width / 2;
  if (width > 1 && middle < count_) {
    const auto begin = corner_.begin() + first;
    const auto end = corner_.begin() + std::min(first + width, count_);
    std::array<double, 2> lengths{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto [low, high] = std::minmax_element(
          begin, end, [&](auto p, auto q) { return corners[p][axis] < corners[q][axis]; });
      lengths[axis] = corners[*high][axis] - corners[*low][axis];
    }
    const std::size_t axis = lengths[1] > lengths[0] ? 1 : 0;
    std::nth_element(begin, corner_.begin() + middle, end,
                     [&](auto p, auto q) { return corners[p][axis] < corners[q][axis]; });
    split(corners, middle, width / 2);
  }
  if (width > 1) {
    split(corners, first, width / 2);
  }
}

void CornerTree::remove(std::uint32_t corner) {
  std::size_t node = std::size_t{leaves_} + leaf_[corner];
  boxes_[node] = {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (node /= 2; node > 0; node /= 2) {
    join_children(node);
  }
}

std::uint32_t CornerTree::any_inside(const Triangle2& triangle) {
  return search(triangle, 1);
}

std::uint32_t CornerTree::search(const Triangle2& triangle, std::size_t node) {
  ++visits_;
  const auto& [low, high] = boxes_[node];
  if (low[0] > high[0] || !may_reach(triangle, low, high)) {
    return count_;
  }
  if (node >= leaves_) {
    const bool is_own = low == triangle[0] || low == triangle[1] || low == triangle[2];
    return is_own ? count_ : corner_[node - leaves_];
  }
  const std::uint32_t found = search(triangle, 2 * node);
  return found != count_ ? found : search(triangle, 2 * node + 1);
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
