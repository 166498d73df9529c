// Triangle against triangle in exact integer arithmetic: the question in which every query ends.
#ifndef FLASHBVH_DETAIL_TRIANGLE_HPP
#define FLASHBVH_DETAIL_TRIANGLE_HPP

#include <stdint.h>

#include "flashbvh/lattice.hpp"

namespace flashbvh::detail {

/// Largest difference along one axis between any two of the six corners, in cells.
///
/// Below 2^20 the six products of a 3x3 determinant of differences add up to less than 6 * 2^60,
/// so 64-bit integers hold the determinant and every partial sum of it.
constexpr int32_t kMaxDifference = (1 << 20) - 1;

/// Answers whether the closed triangles `a` and `b` have a point in common.
///
/// Touching and coplanar overlap count; a triangle degenerated to a segment or a point is tested
/// as that. There is no epsilon, and the order of corners and of arguments changes nothing.
/// Corners may lie anywhere in 32 bits. Where the boxes of the triangles touch, all differences
/// must keep within kMaxDifference, which triangles that each span less than 2^19 cells do by
/// themselves. This is not checked: beyond it the answer is meaningless.
///
/// Cost in instructions on a Cortex-M4 at -O2: at most 135 where the boxes are disjoint, else 330
/// on average and at most 520; up to 1,000 for coplanar triangles and 2,100 for two segments
/// (tests/budget/triangle_cost_test.cpp prints them), more where a difference reaches 2^15.
/// Stack: 104 bytes on Cortex-M3 and M4 at -O2.
///
/// Source: Guigue and Devillers, "Fast and Robust Triangle-Triangle Overlap Test Using Orientation
/// Predicates", Journal of Graphics Tools 8(1), 2003, for the general case.
bool triangles_intersect(const Triangle& a, const Triangle& b) noexcept;

/// The plane of a narrow triangle: coordinates within +-2^17, edges within +-(2^15 - 1) along each
/// axis. 24 bytes.
struct Plane {
  int32_t x, y, z;  ///< the normal, twice the area long
  int64_t start;    ///< the negated height of the triangle above the origin

  Plane() = default;
  Plane(const Point& p, const Point& q, const Point& r) {
    const Point u = {q.x - p.x, q.y - p.y, q.z - p.z};
    const Point v = {r.x - p.x, r.y - p.y, r.z - p.z};
    x = u.y * v.z - u.z * v.y;
    y = u.z * v.x - u.x * v.z;
    z = u.x * v.y - u.y * v.x;
    const auto product = [](int32_t n, int32_t at) { return static_cast<int64_t>(n) * at; };
    start = -(product(x, p.x) + product(y, p.y) + product(z, p.z));
  }
};

/// A triangle as it lies on A's lattice.
struct NearTriangle {
  const Vertex* corner[3];
};

/// The same of narrow triangles. Boxes, which a query tested before, are tested only where the
/// general case does not decide.
bool near_triangles_intersect(const NearTriangle& a, const Triangle& b,
                              const Plane& plane_b) noexcept;

}  // namespace flashbvh::detail

#endif
