// Which corners of a polygon lie in a triangle: boxes over runs of neighbours, in a complete binary
// tree (a segment tree over the polygon's order, in which what is near is mostly near in the
// plane).
#ifndef FLASHBVH_TOOLS_MESH_CORNER_TREE_HPP
#define FLASHBVH_TOOLS_MESH_CORNER_TREE_HPP

#include <array>
#include <cstdint>
#include <vector>

namespace flashbvh::tool {

using Corner2 = std::array<double, 2>;
using Triangle2 = std::array<Corner2, 3>;

/// Twice the area of a triangle, positive if it runs counter-clockwise. Each step of it is monotone
/// in r's coordinates, after rounding too: over a box it is largest in a corner of the box.
inline double turn(const Corner2& p, const Corner2& q, const Corner2& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

class CornerTree {
 public:
  explicit CornerTree(const std::vector<Corner2>& corners);

  void remove(std::uint32_t corner);

  /// The first corner from number `begin` on that is still there and lies in the triangle or on its
  /// rim, but not where one of the triangle's own corners lies; the number of corners if there is
  /// none. Exactly the corners that turn() places so: no box is passed over that holds one.
  std::uint32_t first_inside(const Triangle2& triangle, std::uint32_t begin) const;

 private:
  struct Box {
    Corner2 low;
    Corner2 high;
  };

  std::uint32_t search(const Triangle2& triangle, std::uint32_t begin, std::size_t node,
                       std::uint32_t first, std::uint32_t width) const;
  void join_children(std::size_t node);

  std::uint32_t count_;
  std::uint32_t leaves_ = 1;  ///< a power of two; leaf i is node leaves_ + i
  std::vector<Box> boxes_;    ///< of node i; its children are 2i and 2i + 1
};

}  // namespace flashbvh::tool

#endif
