#include "mesh/polygon.hpp"

#include <algorithm>
#include <cmath>
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

using Triangle2 = std::array<Corner2, 3>;

bool is_inside(const Corner2& at, const Triangle2& triangle) {
  return turn(triangle[0], triangle[1], at) >= 0 && turn(triangle[1], triangle[2], at) >= 0 &&
         turn(triangle[2], triangle[0], at) >= 0;
}

/// The rest of a polygon while ears are cut off. The next ear is the first corner in order that is
/// an ear; the polygon's first corner is tested last.
///
/// A corner that is no ear is tested again only if its triangle changes, or if the corner that lay
/// in its triangle is removed. Corners are never added.
class EarCutter {
 public:
  explicit EarCutter(const std::vector<Corner2>& flat) : flat_(flat), waiting_(flat.size()) {
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
    const std::uint32_t inside = any_inside(triangle);
    if (inside == flat_.size()) {
      return true;
    }
    waiting_[inside].push_back(corner);
    return false;
  }

  /// A remaining corner in the triangle or on its rim, but not at one of its own corners; the
  /// number of corners if there is none.
  std::uint32_t any_inside(const Triangle2& triangle) const {
    std::uint32_t corner = head_;
    do {
      const Corner2& at = flat_[corner];
      const bool is_own = at == triangle[0] || at == triangle[1] || at == triangle[2];
      if (!is_own && is_inside(at, triangle)) {
        return corner;
      }
      corner = next_[corner];
    } while (corner != head_);
    return static_cast<std::uint32_t>(flat_.size());
  }

  void remove(std::uint32_t corner) {
    const std::uint32_t before = before_[corner];
    const std::uint32_t next = next_[corner];
    next_[before] = next;
    before_[next] = before;
    head_ = corner == head_ ? next : head_;
    for (const std::uint32_t other : waiting_[corner]) {
      if (next_[before_[other]] == other) {  // still there
        to_test_.insert(other);
      }
    }
    to_test_.insert({before, next});
    to_test_.erase(corner);
  }

  const std::vector<Corner2>& flat_;
  std::uint32_t head_ = 0;           ///< the first remaining corner
  std::vector<std::uint32_t> next_;  ///< of remaining corners
  std::vector<std::uint32_t> before_;
  std::set<std::uint32_t> to_test_;                  ///< may be ears; other corners are none
  std::vector<std::vector<std::uint32_t>> waiting_;  ///< [corner]: those in whose triangles it lay
};

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

}  // namespace flashbvh::tool
