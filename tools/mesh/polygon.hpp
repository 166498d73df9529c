// Cuts polygons into triangles.
//
// CornerTree finds a polygon's corners in a triangle: a complete binary tree of boxes over corners
// near in the plane. Runs of the polygon's order would not do: the boxes of a star's rays overlap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flashbvh::tool {

/// Cuts a polygon of n >= 3 corners into exactly n - 2 triangles by cutting off ears; a convex one
/// becomes a fan from its first corner. Corners are the indices 0 to n - 1. Also cuts polygons that
/// cross themselves or have no area. O(n log n) for most polygons, O(n^1.5) if many corners lie
/// near long edges, as in a star of many rays; O(n^2) at worst.
///
/// assimp's triangulation omits triangles of less than 1e-5 square units.
std::vector<std::array<std::uint32_t, 3>> triangulate(
    const std::vector<std::array<double, 3>>& corners);

using Corner2 = std::array<double, 2>;
using Triangle2 = std::array<Corner2, 3>;

/// Twice the area of a triangle, positive if it runs counter-clockwise. Each operation is monotone
/// in r's coordinates, even with rounding: over a box, it is largest at a corner of the box.
inline double turn(const Corner2& p, const Corner2& q, const Corner2& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

class CornerTree {
 public:
  explicit CornerTree(const std::vector<Corner2>& corners);

  void remove(std::uint32_t corner);

  /// A remaining corner in the triangle or on its rim, but not at one of its own corners; the
  /// number of corners if there is none. Exact with respect to turn(): skips no box with such a
  /// corner.
  std::uint32_t any_inside(const Triangle2& triangle);

  /// The number of nodes that any_inside() has visited.
  std::size_t visits() const { return visits_; }

 private:
  struct Box {
    Corner2 low;
    Corner2 high;
  };

  void split(const std::vector<Corner2>& corners, std::uint32_t first, std::uint32_t width);
  std::uint32_t search(const Triangle2& triangle, std::size_t node);
  void join_children(std::size_t node);

  std::uint32_t count_;
  std::uint32_t leaves_ = 1;           ///< a power of two; leaf i is node leaves_ + i
  std::vector<std::uint32_t> corner_;  ///< of each leaf that has one
  std::vector<std::uint32_t> leaf_;    ///< of each corner
  std::vector<Box> boxes_;             ///< of node i; its children are 2i and 2i + 1
  std::size_t visits_ = 0;
};

}  // namespace flashbvh::tool
