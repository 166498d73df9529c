// Finds the triangle of a mesh that is nearest to a point, in double precision.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::simplify {

using Point = std::array<double, 3>;
using PointTriangle = std::array<Point, 3>;

inline PointTriangle triangle_of(const bake::SourceMesh& mesh,
                                 const bake::TriangleCorners& corners) {
  return {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
}

/// The bounds of points; none at first.
struct Box {
  Point low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Point high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Point& p);
  double squared_distance(const Point& p) const;
};

/// The squared distance to a point of the triangle that is nearest except for rounding: never less
/// than the true distance by more than the rounding of coordinates.
double squared_distance(const Point& p, const PointTriangle& triangle);

Point minus(const Point& p, const Point& q);
Point cross(const Point& u, const Point& v);
double dot(const Point& u, const Point& v);
/// Cuts a triangle at the middles of its edges.
std::array<PointTriangle, 4> quarters_of(const PointTriangle& triangle);
Point centre_of(const PointTriangle& triangle);
/// The radius of the ball about `centre` that holds the triangle.
double radius_of(const PointTriangle& triangle, const Point& centre);

/// Cuts `part` where it leaves `triangle`, seen along the triangle's normal, by more than `least`,
/// or else at the middles of its edges. Up to rounding, the three or four parts make up `part`.
std::vector<PointTriangle> cut(const PointTriangle& part, const PointTriangle& triangle,
                               double least);

class NearestTriangle {
 public:
  /// `mesh` has at least one triangle.
  explicit NearestTriangle(const bake::SourceMesh& mesh);

  struct Found {
    std::uint32_t place = 0;  ///< argument of triangle(), and the best `hint` for near points
    double squared = HUGE_VAL;
  };
  /// `hint`: the triangle to test first.
  Found to(const Point& p, std::uint32_t hint = 0) const;
  const PointTriangle& triangle(std::uint32_t place) const { return triangles_[place]; }
  /// The triangle's number in the mesh.
  std::uint32_t number(std::uint32_t place) const { return numbers_[place]; }

 private:
  struct Node {
    Box box;
    std::uint32_t first;  ///< triangle of a leaf, or the right child; the left one is next
    std::uint32_t count;  ///< 0: no leaf
  };
  void build(std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t count,
             const std::vector<PointTriangle>& source);

  std::vector<Node> nodes_;
  std::vector<PointTriangle> triangles_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace flashbvh::simplify
