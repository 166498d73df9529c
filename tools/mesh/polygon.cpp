#include "mesh/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flashbvh::tool {
namespace {

using Corner2 = std::array<double, 2>;
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

/// Twice the area of a triangle, positive if it runs counter-clockwise.
double turn(const Corner2& p, const Corner2& q, const Corner2& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

/// True if the triangle is convex, and no corner of those left lies in it or on its rim, but at its
/// own corners.
bool is_ear(const std::vector<Corner2>& flat, const std::vector<std::uint32_t>& left,
            const std::array<std::uint32_t, 3>& triangle) {
  const Corner2& p = flat[triangle[0]];
  const Corner2& q = flat[triangle[1]];
  const Corner2& r = flat[triangle[2]];
  return turn(p, q, r) > 0 && std::none_of(left.begin(), left.end(), [&](std::uint32_t corner) {
           const Corner2& at = flat[corner];
           return at != p && at != q && at != r && turn(p, q, at) >= 0 && turn(q, r, at) >= 0 &&
                  turn(r, p, at) >= 0;
         });
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Corner3>& corners) {
  if (corners.size() == 3) {
    return {{0, 1, 2}};
  }
  const std::vector<Corner2> flat = projected(corners);
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    left.push_back(i);
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t at = 1;
  std::size_t refused = 0;  // corners since the last ear
  while (left.size() > 3) {
    const std::size_t count = left.size();
    const std::array<std::uint32_t, 3> triangle = {left[(at + count - 1) % count], left[at],
                                                   left[(at + 1) % count]};
    if (refused < count && !is_ear(flat, left, triangle)) {
      at = (at + 1) % count;
      ++refused;
      continue;
    }
    triangles.push_back(triangle);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    at %= left.size();
    refused = 0;
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace flashbvh::tool
