#include "mesh/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flashbvh::tool {
namespace {

using Corner3 = std::array<double, 3>;
using Corner2 = std::array<double, 2>;

/// Newell's normal: the polygon's areas in the three projections, twice.
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

/// Along the axis in which the polygon is widest, so that it runs counter-clockwise.
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

double turn(const Corner2& p, const Corner2& q, const Corner2& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

/// Whether the corner at `at` is convex and no other corner lies in its triangle.
bool is_ear(const std::vector<Corner2>& flat, const std::vector<std::uint32_t>& left,
            std::size_t at) {
  const Corner2& p = flat[left[(at + left.size() - 1) % left.size()]];
  const Corner2& q = flat[left[at]];
  const Corner2& r = flat[left[(at + 1) % left.size()]];
  if (!(turn(p, q, r) > 0)) {
    return false;
  }
  return std::none_of(left.begin(), left.end(), [&](std::uint32_t i) {
    const Corner2& other = flat[i];
    return other != p && other != q && other != r && turn(p, q, other) >= 0 &&
           turn(q, r, other) >= 0 && turn(r, p, other) >= 0;
  });
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Corner3>& corners) {
  const std::vector<Corner2> flat = projected(corners);
  std::vector<std::uint32_t> left(corners.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    left[i] = static_cast<std::uint32_t>(i);
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  while (left.size() > 3) {
    std::size_t ear = 1;  // the one to cut off if there is none
    for (std::size_t i = 0; i < left.size(); ++i) {
      const std::size_t at = (i + 1) % left.size();
      if (is_ear(flat, left, at)) {
        ear = at;
        break;
      }
    }
    const std::size_t before = (ear + left.size() - 1) % left.size();
    triangles.push_back({left[before], left[ear], left[(ear + 1) % left.size()]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace flashbvh::tool
