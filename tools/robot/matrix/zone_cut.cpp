#include "robot/matrix/zone_cut.hpp"

#include <algorithm>
#include <cmath>

namespace flashbvh::tool {
namespace {

/// Halving ends at this number of pieces: firmware gets some of them, and its 16-bit indices reach
/// 65,535 triangles and vertices.
constexpr std::size_t kMostPieces = 24'000;

Vector3 between(const Vector3& p, const Vector3& q, double part) {
  return {p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1]), p[2] + part * (q[2] - p[2])};
}

/// The part of a convex polygon, not an empty one, where `height` is 0 or less; `crossing` of a
/// corner where it is and one where it is not: where the edge between them leaves that part.
template <class Height, class Crossing>
std::vector<Vector3> clipped(const std::vector<Vector3>& polygon, const Height& height,
                             const Crossing& crossing) {
  std::vector<Vector3> part;
  part.reserve(polygon.size() + 1);
  bool has_p = height(polygon.front()) <= 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3& p = polygon[i];
    const Vector3& q = polygon[(i + 1) % polygon.size()];
    const bool has_q = height(q) <= 0;
    if (has_p) {
      part.push_back(p);
    }
    if (has_p != has_q) {
      part.push_back(has_p ? crossing(p, q) : crossing(q, p));
    }
    has_p = has_q;
  }
  return part;
}

/// The corners of a convex part of `p`. It holds all points of `p` within `distance` of `q`; along
/// the normals of q's plane and edges, it is no farther than that.
std::vector<Vector3> near_part(const PointTriangle& p, const PointTriangle& q, double distance) {
  std::vector<Vector3> part(p.begin(), p.end());
  const auto keep = [&](const Vector3& normal, const Vector3& at) {
    const double most = distance * length_of(normal);
    const auto height = [&](const Vector3& x) {
      return simplify::dot(normal, simplify::minus(x, at)) - most;
    };
    if (std::any_of(part.begin(), part.end(), [&](const Vector3& x) { return height(x) > 0; })) {
      part = clipped(part, height, [&](const Vector3& u, const Vector3& w) {
        return between(u, w, height(u) / (height(u) - height(w)));
      });
    }
  };
  const Vector3 normal = simplify::cross(simplify::minus(q[1], q[0]), simplify::minus(q[2], q[0]));
  keep(normal, q[0]);
  keep({-normal[0], -normal[1], -normal[2]}, q[0]);
  simplify::Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    keep(simplify::cross(simplify::minus(q[(i + 1) % 3], q[i]), normal), q[i]);
    box.add(q[i]);
  }
  // Planes along the edges of a sliver meet far from it.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector3 along{};
    along[axis] = 1;
    keep(along, box.high);
    along[axis] = -1;
    keep(along, box.low);
  }
  return part;
}

template <class Points>
double farthest(const ZoneShape& shape, const Points& points) {
  double most = 0;
  for (const Vector3& point : points) {
    most = std::max(most, shape.distance_of(point));
  }
  return most;
}

}  // namespace

PointTriangle placed_triangle(const Transform& transform, const PointTriangle& triangle) {
  return {placed(transform, triangle[0]), placed(transform, triangle[1]),
          placed(transform, triangle[2])};
}

double radius_between(const ZoneShape& shape, const PointTriangle& p, const PointTriangle& q,
                      double distance, double least) {
  if (std::min(farthest(shape, p), farthest(shape, q)) <= least) {
    return least;
  }
  const double of_p = farthest(shape, near_part(p, q, distance));
  return of_p <= least
             ? least
             : std::max(least, std::min(of_p, farthest(shape, near_part(q, p, distance))));
}

void ZoneCut::add(const PointTriangle& triangle) {
  std::vector<PointTriangle> pieces;
  if (cut(triangle, pieces)) {
    pieces = {triangle};
  } else {
    pieces_ += pieces.size();
  }
  for (const PointTriangle& piece : pieces) {
    bake::TriangleCorners corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto number = static_cast<std::uint32_t>(mesh_.vertices.size());
      const auto [place, is_new] = vertices_.try_emplace(piece[i], number);
      if (is_new) {
        mesh_.vertices.push_back(piece[i]);
      }
      corners[i] = place->second;
    }
    mesh_.triangles.push_back(corners);
  }
}

/// Halves the triangle across its longest edge until pieces are small or wholly inside or outside.
/// True if all of it is outside.
bool ZoneCut::cut(const PointTriangle& triangle, std::vector<PointTriangle>& pieces) const {
  std::size_t longest = 0;
  double edge = 0;
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = length_of(simplify::minus(triangle[(i + 1) % 3], triangle[i]));
    most = std::max(most, length_of(from_middle(triangle[i])));
    if (length > edge) {
      edge = length;
      longest = i;
    }
  }
  if (most <= shape_.radius) {
    return false;  // the shape is convex
  }
  // No point of a triangle is farther from its centre than its longest edge.
  if (length_of(from_middle(simplify::centre_of(triangle))) - edge >= shape_.radius) {
    pieces.push_back(triangle);
    return true;
  }
  if (edge <= edge_ || pieces_ + pieces.size() > kMostPieces) {
    return clip(triangle, pieces);
  }
  const Vector3& p = triangle[longest];
  const Vector3& q = triangle[(longest + 1) % 3];
  const Vector3& other = triangle[(longest + 2) % 3];
  const Vector3 middle = between(std::min(p, q), std::max(p, q), 0.5);
  const bool is_first_whole = cut({p, middle, other}, pieces);
  return cut({middle, q, other}, pieces) && is_first_whole;
}

/// Cuts off corners inside, along straight lines: what is cut off is convex, with all corners in
/// the zone.
bool ZoneCut::clip(const PointTriangle& triangle, std::vector<PointTriangle>& pieces) const {
  const std::vector<Vector3> part = clipped(
      {triangle.begin(), triangle.end()},
      [&](const Vector3& p) { return shape_.radius - length_of(from_middle(p)); },
      [&](const Vector3& outside, const Vector3& inside) { return crossing(inside, outside); });
  for (std::size_t i = 2; i < part.size(); ++i) {
    pieces.push_back({part[0], part[i - 1], part[i]});
  }
  return std::equal(part.begin(), part.end(), triangle.begin(), triangle.end());
}

Vector3 ZoneCut::crossing(const Vector3& inside, const Vector3& outside) const {
  const Vector3 from = from_middle(inside);
  const Vector3 step = simplify::minus(from_middle(outside), from);
  const double a = simplify::dot(step, step);
  const double b = simplify::dot(from, step);
  const double c = simplify::dot(from, from) - shape_.radius * shape_.radius;
  const double part = (std::sqrt(std::max(0.0, b * b - a * c)) - b) / a;
  return between(inside, outside, std::clamp(part, 0.0, 1.0));
}

}  // namespace flashbvh::tool
