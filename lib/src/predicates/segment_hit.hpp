// A segment and a triangle: where they first meet, and whether the one goes through the other.
#ifndef FLASHBVH_PREDICATES_SEGMENT_HIT_HPP
#define FLASHBVH_PREDICATES_SEGMENT_HIT_HPP

#include "flashbvh/lattice.hpp"
#include "orientation.hpp"

namespace flashbvh::detail {

/// Components of cross products of a segment's way and what is seen from its start.
struct WideVector {
  int64_t x;
  int64_t y;
  int64_t z;
};

/// Whether the segment has a point of the closed triangle; then where it first has, and the side of
/// RayHit. The segment's ends are within kMaxRayCoordinate, corners within 2^15; degenerate ones of
/// both are what they are.
bool first_meeting(const Segment& segment, const Triangle& t, SegmentShare& along,
                   int8_t& side) noexcept;

/// 1 or -1 as the line from `from` along `way` goes through a triangle along its normal or against
/// it; 0 if it goes past. The line is moved by (e, e^2, e^3) for e below any number.
int passage(const Triangle& t, const Point& from, const Vector& way) noexcept;

/// 1 if `p`, moved alike, is above the triangle's plane, -1 if it is below. Not of a triangle
/// without area.
int side_of_plane(const Triangle& t, const Point& p) noexcept;

}  // namespace flashbvh::detail

#endif
