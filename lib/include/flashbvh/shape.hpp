// Shapes made at run time, in the caller's memory: a point, a segment, a triangle, a box.
//
// A shape is a mesh of one leaf, so every query takes it, on either side, under any pose:
//     a sphere     closer_than(mesh, PointShape, pose, radius)
//     a capsule    closer_than(mesh, SegmentShape, pose, radius)
//     a thick plate  closer_than(mesh, TriangleShape, pose, half of its thickness)
//     a box        intersects(mesh, BoxShape, pose)
// distance() measures to a point, segment or triangle: subtract the radius from it.
//
// Coordinates are in cells of the shape's frame, rounded to the nearest: a workcell counts half a
// cell's diagonal for it. The shape's cell is the tested mesh's.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// A mesh of one leaf with its arrays. Points into itself: it is not copied, and set again in
/// place. 72 bytes and 26 + 8 * triangles + 6 * vertices.
template <uint16_t triangles, uint16_t vertices>
class Shape {
 public:
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;

  /// Returns the mesh, for queries.
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

  /// Returns `done`; `not_open`: `like` is not; or `shape_too_large`: a coordinate is more than
  /// 16,383 cells from the middle, or beyond 2^29. Until it is set again, such a shape has no valid
  /// cell and no inside: queries and rays of it end with `cell_mismatch`, inside() with
  /// `not_closed`.
  [[nodiscard]] Status status() const { return status_; }

 protected:
  /// Takes the cell of `like`, unusable until the points are set.
  FLASHBVH_NOINLINE explicit Shape(const Mesh& like, const uint8_t (&corners)[triangles][3]) {
    for (uint16_t i = 0; i < triangles; ++i) {
      corners_[i] = {{corners[i][0], corners[i][1], corners[i][2]}};
      ids_[i] = i;
    }
    mesh_.nodes = &node_;
    mesh_.node_count = 1;
    mesh_.leaf_count = 1;
    mesh_.stack_need = 0;
    mesh_.triangles = corners_;
    mesh_.triangle_ids = ids_;
    mesh_.leaf_offsets = triangles == 1 ? nullptr : offsets_;
    mesh_.vertices = vertices_;
    mesh_.shell_vertices = &first_;
    mesh_.triangle_count = triangles;
    mesh_.vertex_count = vertices;
    mesh_.shell_count = 1;
    mesh_.unit = like.unit;
    mesh_.deviation_sixteenths = kRoundingDeviation;
    mesh_.cell_bits = like.cell_bits | detail::kUnusableCell;
  }

  /// Sets all vertices.
  void set_points(const Point (&points)[vertices]) {
    Point least = points[0];
    Point most = points[0];
    for (const Point& p : points) {
      least = {lesser(least.x, p.x), lesser(least.y, p.y), lesser(least.z, p.z)};
      most = {greater(most.x, p.x), greater(most.y, p.y), greater(most.z, p.z)};
    }
    const Point middle = {half(least.x, most.x), half(least.y, most.y), half(least.z, most.z)};
    if (!fits(least, middle) || !fits(most, middle)) {
      status_ = Status::shape_too_large;
      mesh_.cell_bits |= detail::kUnusableCell;
      mesh_.is_closed = false;
      return;
    }
    status_ = detail::has_cell(mesh_) ? Status::done : Status::not_open;
    mesh_.cell_bits &= ~detail::kUnusableCell;
    mesh_.is_closed = kIsClosed;
    mesh_.origin[0] = middle.x;
    mesh_.origin[1] = middle.y;
    mesh_.origin[2] = middle.z;
    for (uint16_t i = 0; i < vertices; ++i) {
      vertices_[i] = from(points[i], middle);
    }
    node_ = {pack({from(least, middle), from(most, middle)}), 1, Node<uint16_t>::kLeafFlag};
    // The diagonal is at least as long as any edge.
    const int64_t x = int64_t{most.x} - least.x;
    const int64_t y = int64_t{most.y} - least.y;
    const int64_t z = int64_t{most.z} - least.z;
    mesh_.longest_edge =
        static_cast<uint16_t>(detail::square_root(detail::widened(x * x + y * y + z * z)) + 1);
  }

 private:
  static constexpr int32_t kMostOrigin = 1 << 29;
  static constexpr bool kIsClosed = triangles > 1;  // a box

  static int32_t lesser(int32_t u, int32_t v) { return u < v ? u : v; }
  static int32_t greater(int32_t u, int32_t v) { return u < v ? v : u; }
  static int32_t half(int32_t u, int32_t v) { return static_cast<int32_t>((int64_t{u} + v) >> 1); }
  static bool fits(int64_t at, int32_t middle) {
    return middle >= -kMostOrigin && middle <= kMostOrigin && at - middle >= -kMaxCoordinate &&
           at - middle <= kMaxCoordinate;
  }
  static bool fits(const Point& p, const Point& middle) {
    return fits(p.x, middle.x) && fits(p.y, middle.y) && fits(p.z, middle.z);
  }
  static Vertex from(const Point& p, const Point& middle) {
    return {static_cast<int16_t>(p.x - middle.x), static_cast<int16_t>(p.y - middle.y),
            static_cast<int16_t>(p.z - middle.z)};
  }

  Mesh mesh_{};
  Node<uint16_t> node_{{0, 0, 0}, 1, Node<uint16_t>::kLeafFlag};
  Corners<uint16_t> corners_[triangles];
  uint16_t ids_[triangles];
  uint16_t offsets_[2] = {0, triangles};
  uint16_t first_ = 0;
  Vertex vertices_[vertices] = {};
  Status status_ = Status::not_open;
};

// Kept out of line for the smaller shapes, so that its frame is gone before queries run.

/// A point.
class PointShape : public Shape<1, 1> {
 public:
  /// With the cell of `like`; see status().
  PointShape(const Mesh& like, const Point& at) : Shape(like, {{0, 0, 0}}) { set(at); }
  /// Sets it again; see status().
  FLASHBVH_NOINLINE void set(const Point& at) { set_points({at}); }
};

/// A segment from `p` to `q`.
class SegmentShape : public Shape<1, 2> {
 public:
  /// With the cell of `like`; see status().
  SegmentShape(const Mesh& like, const Point& p, const Point& q) : Shape(like, {{0, 1, 1}}) {
    set(p, q);
  }
  /// Sets it again; see status().
  FLASHBVH_NOINLINE void set(const Point& p, const Point& q) { set_points({p, q}); }
};

/// A triangle.
class TriangleShape : public Shape<1, 3> {
 public:
  /// With the cell of `like`; see status().
  TriangleShape(const Mesh& like, const Triangle& t) : Shape(like, {{0, 1, 2}}) { set(t); }
  /// Sets it again; see status().
  FLASHBVH_NOINLINE void set(const Triangle& t) { set_points(t.corner); }
};

namespace detail {

/// Corner i has the upper x if bit 0 of i is set, the upper y for bit 1, the upper z for bit 2.
inline constexpr uint8_t kBoxTriangles[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                                 {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                                 {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};

}  // namespace detail

/// A closed box between two corners; `lower` must not exceed `upper` along any axis.
class BoxShape : public Shape<12, 8> {
 public:
  /// With the cell of `like`; see status().
  BoxShape(const Mesh& like, const Point& lower, const Point& upper)
      : Shape(like, detail::kBoxTriangles) {
    set(lower, upper);
  }
  /// Sets it again; see status().
  void set(const Point& lower, const Point& upper) {
    Point points[8];
    for (int i = 0; i < 8; ++i) {
      points[i] = {((i & 1) != 0 ? upper : lower).x, ((i & 2) != 0 ? upper : lower).y,
                   ((i & 4) != 0 ? upper : lower).z};
    }
    set_points(points);
  }
};

}  // namespace flashbvh
