// A link's triangles in this program's own tree of boxes.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry.hpp"

namespace robot_check {

class Body {
 public:
  struct Node {
    Vec centre;
    Vec half;             ///< of the box
    double radius;        ///< of a ball about `centre` that contains all vertices below
    std::uint32_t first;  ///< of its triangles
    std::uint32_t count;  ///< 1: a leaf
    std::uint32_t right;  ///< child; the left one is the next node
  };

  explicit Body(std::vector<Triangle> triangles);

  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// The distance from a point, but at most `most`.
  double distance(const Vec& point, double most = HUGE_VAL) const;

 private:
  void build(std::size_t first, std::size_t count);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace robot_check
