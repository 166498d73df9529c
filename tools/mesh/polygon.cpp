#include "mesh/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace flashbvh::tool {
namespace {

using Corner3 = std::array<double, 3>;

/// Newell's normal: twice the polygon's areas in the three projections.
Corner3 normal_of(const std::vector<Corner3>& corners) {
  Corner3 normal{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner3& p = corners[i];
    const Corner3& q = corners[(i + 1) % corners.size()];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3;
      const std::size_t v = (axis + 2) % 3;
      normal[axis] += (p[u] - q[u]) * (p[v] + q[v]);
    }
  }
  return normal;
}

/// Projects along the axis of the largest area, so that the polygon runs counter-clockwise.
std::vector<Corner2> projected(const std::vector<Corner3>& corners) {
  const Corner3 normal = normal_of(corners);
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    axis = std::fabs(normal[i]) > std::fabs(normal[axis]) ? i : axis;
  }
  std::size_t u = (axis + 1) % 3;
  std::size_t v = (axis + 2) % 3;
  if (normal[axis] < 0) {
    std::swap(u, v);
  }
  std::vector<Corner2> flat;
  flat.reserve(corners.size());
  for (const Corner3& corner : corners) {
    flat.push_back({corner[u], corner[v]});
  }
  return flat;
}

/// The rest of a polygon while ears are cut off. The next ear is the first corner in order that is
/// an ear; the polygon's first corner is tested last.
///
/// A corner that is no ear is tested again only if its triangle changes, or if the corner that lay
/// in its triangle is removed. Corners are never added.
class EarCutter {
 public:
  explicit EarCutter(const std::vector<Corner2>& flat)
      : flat_(flat), tree_(flat), waiting_(flat.size()) {
    const auto count = static_cast<std::uint32_t>(flat.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      next_.push_back((i + 1) % count);
      before_.push_back((i + count - 1) % count);
      to_test_.insert(to_test_.end(), i);
    }
  }

  std::array<std::uint32_t, 3> cut() {
    const std::uint32_t ear = next_ear();
    const std::array<std::uint32_t, 3> triangle = {before_[ear], ear, next_[ear]};
    remove(ear);
    return triangle;
  }

  std::array<std::uint32_t, 3> last() const { return {head_, next_[head_], before_[head_]}; }

 private:
  /// The corner after the first one if there is no ear.
  std::uint32_t next_ear() {
    for (auto at = to_test_.upper_bound(head_); at != to_test_.end(); at = to_test_.erase(at)) {
      if (is_ear(*at)) {
        return *at;
      }
    }
    if (to_test_.erase(head_) != 0 && is_ear(head_)) {
      return head_;
    }
    return next_[head_];
  }

  /// True if the corner is convex and no other corner lies in its triangle.
  bool is_ear(std::uint32_t corner) {
    const Triangle2 triangle = {flat_[before_[corner]], flat_[corner], flat_[next_[corner]]};
    if (!(turn(triangle[0], triangle[1], triangle[2]) > 0)) {
      return false;
    }
    const std::uint32_t inside = tree_.any_inside(triangle);
    if (inside == flat_.size()) {
      return true;
    }
    waiting_[inside].push_back(corner);
    return false;
  }

  void remove(std::uint32_t corner) {
    const std::uint32_t before = before_[corner];
    const std::uint32_t next = next_[corner];
    next_[before] = next;
    before_[next] = before;
    head_ = corner == head_ ? next : head_;
    tree_.remove(corner);
    for (const std::uint32_t other : waiting_[corner]) {
      if (next_[before_[other]] == other) {  // still there
        to_test_.insert(other);
      }
    }
    to_test_.insert({before, next});
    to_test_.erase(corner);
  }

  const std::vector<Corner2>& flat_;
  CornerTree tree_;
  std::uint32_t head_ = 0;           ///< the first remaining corner
  std::vector<std::uint32_t> next_;  ///< of remaining corners
  std::vector<std::uint32_t> before_;
  std::set<std::uint32_t> to_test_;                  ///< may be ears; other corners are none
  std::vector<std::vector<std::uint32_t>> waiting_;  ///< [corner]: those in whose triangles it lay
};

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

std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Corner3>& corners) {
  if (corners.size() == 3) {
    return {{0, 1, 2}};
  }
  const std::vector<Corner2> flat = projected(corners);
  EarCutter cutter(flat);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  while (triangles.size() < corners.size() - 3) {
    triangles.push_back(cutter.cut());
  }
  triangles.push_back(cutter.last());
  return triangles;
}

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

/// Halves the leaves from `first` on that have corners, across the longer side.
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
