// First common point of a segment and a triangle, and the passage of a line through a triangle.
#pragma once

#include "flashbvh/lattice.hpp"
#include "orientation.hpp"

namespace flashbvh::detail {

/// A cross product of a segment's direction, a triangle's edges or vectors from the start.
struct WideVector {
  int64_t x;
  int64_t y;
  int64_t z;
};

/// Returns whether the segment meets the closed triangle. If so, sets the share of the first common
/// point and the side of RayHit. The segment's ends are within kMaxRayCoordinate, corners within
/// 2^15; both may be degenerate.
bool first_meeting(const Segment& segment, const Triangle& t, SegmentShare& along,
                   int8_t& side) noexcept;

/// 1 or -1 if the line from `from` along `way` passes through a triangle along or against its
/// normal; 0 if it misses. The line is moved by (e, e^2, e^3), with e smaller than any number.
int passage(const Triangle& t, const Point& from, const Vector& way) noexcept;

/// 1 if `p`, moved by (e, e^2, e^3), is above the triangle's plane, -1 if it is below. The triangle
/// must have an area.
int side_of_plane(const Triangle& t, const Point& p) noexcept;

}  // namespace flashbvh::detail
