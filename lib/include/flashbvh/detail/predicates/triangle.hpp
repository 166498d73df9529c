// Triangle against triangle in exact integer arithmetic: the last test of every query.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/lattice/box_packed.hpp"
#include "flashbvh/lattice.hpp"

namespace flashbvh::detail {

/// Largest difference along one axis between any two of the six corners, in cells.
///
/// Below 2^20 the six products of a 3x3 determinant of differences add up to less than 6 * 2^60. So
/// 64-bit integers hold the determinant and every partial sum of it.
constexpr int32_t kMaxDifference = (1 << 20) - 1;

/// True if the closed triangles `a` and `b` have a point in common.
///
/// Touching and coplanar overlap count; a degenerate triangle is tested as a segment or a point.
/// There is no epsilon, and the order of corners and of arguments changes nothing.
/// Corners may lie anywhere in 32 bits. If the boxes of the triangles touch, all differences must
/// be within kMaxDifference; they are if each triangle spans less than 2^19 cells. This is not
/// checked: beyond it the answer is meaningless.
///
/// Cost in instructions on a Cortex-M4 at -O2: at most 135 where the boxes are disjoint, else 265
/// on average and at most 390. Up to 950 for coplanar triangles and 2,100 for two segments; more
/// where a difference reaches 2^15 (tests/predicates/contact_cost_test.cpp prints them).
/// Stack: 104 bytes on Cortex-M3 and M4 at -O2.
///
/// Source: Guigue and Devillers, "Fast and Robust Triangle-Triangle Overlap Test Using Orientation
/// Predicates", Journal of Graphics Tools 8(1), 2003, for the general case.
bool triangles_intersect(const Triangle& a, const Triangle& b) noexcept;

/// True if a box overlaps a triangle's box on the same lattice, within +-2^20 cells.
bool box_overlaps(const PackedBox& box, const Triangle& t) noexcept;

/// The normal of a triangle's plane; its length is twice the triangle's area.
struct PlaneNormal {
  int32_t x;
  int32_t y;
  int32_t z;
};

/// Gets the normal of a narrow triangle: edges within +-(2^15 - 1) along each axis.
void get_near_normal(const Triangle& t, PlaneNormal& normal) noexcept;

/// triangles_intersect() for narrow triangles with all differences within kMaxDifference, whose
/// boxes may be disjoint. As a query has tested their leaves' boxes, their own boxes are tested
/// only if one is flat or lies in the other's plane. `normal_b`: of `b`.
bool near_triangles_intersect(const Triangle& a, const Triangle& b,
                              const PlaneNormal& normal_b) noexcept;
/// triangles_intersect() for triangles that may not be narrow; tests the boxes first.
bool wide_triangles_intersect(const Triangle& a, const Triangle& b) noexcept;

}  // namespace flashbvh::detail
