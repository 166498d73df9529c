// Rays of floating point, as sensors give them: an origin, a direction and a reach.
//
// Optional, like pose_float.hpp, and without float arithmetic: the segment is the same on every
// core. Stack: 304 bytes on Cortex-M3 to M55 at -O2. How it rounds: the start lies within half a
// cell of the origin along each axis, the end within 0.51 cells of where direction and reach end;
// so at the reach the segment is at most 0.9 cells beside the ray.
#ifndef FLASHBVH_RAY_FLOAT_HPP
#define FLASHBVH_RAY_FLOAT_HPP

#include <stdint.h>

#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/pose_float.hpp"
#include "flashbvh/ray.hpp"

namespace flashbvh {

/// A segment, or why there is none.
struct [[nodiscard]] MadeSegment {
  Status status;
  Segment segment;
};

namespace detail {

/// Largest coordinate of a segment's end, in cells: that of a mesh's origin, and a ray's.
constexpr int64_t kMostOfSegment = (int64_t{1} << 29) + kMaxRayCoordinate;

/// Of 1/65,536 of a cell, halves up.
inline int64_t whole_cells(int64_t fractions) {
  return (fractions + 0x8000) >> 16;
}

/// A vector of floats, which are finite and not all 0, as whole numbers below 2^30 in proportion to
/// it, the largest of them 2^28 at least.
inline bool get_direction(const float (&direction)[3], int32_t (&whole)[3]) {
  FloatParts parts[3];
  int32_t highest = INT32_MIN;
  for (int i = 0; i < 3; ++i) {
    parts[i] = parts_of(direction[i]);
    if (!parts[i].is_finite) {
      return false;
    }
    if (parts[i].digits != 0) {
      const int32_t top = parts[i].exponent + 32 - __builtin_clz(parts[i].digits);
      highest = top < highest ? highest : top;
    }
  }
  for (int i = 0; i < 3; ++i) {
    const auto size =
        static_cast<int32_t>(scaled(parts[i].digits, parts[i].exponent + 29 - highest));
    whole[i] = parts[i].is_negative ? -size : size;
  }
  return highest != INT32_MIN;
}

/// part / whole in 31 fraction bits, rounded down: part <= whole < 2^31.
inline uint32_t share_of(uint32_t part, uint32_t whole) {
  uint32_t share = 0;
  for (int bit = 0; bit < 32; ++bit) {
    const bool fits = part >= whole;
    part = (fits ? part - whole : part) << 1;
    share = share << 1 | (fits ? 1 : 0);
  }
  return share;
}

/// `reach`, below 2^37, times a component of a direction of this length: within 2^-9 of a cell.
inline int64_t way_along(int64_t reach, int32_t component, uint32_t length) {
  const bool negative = component < 0;
  const uint32_t share = share_of(static_cast<uint32_t>(negative ? -component : component), length);
  const int64_t way = ((reach >> 16) * share >> 15) + ((reach & 0xFFFF) * share >> 31);
  return negative ? -way : way;
}

}  // namespace detail

/// The segment from `origin` along `direction`, of any length but 0, as far as `reach`; origin and
/// reach in the mesh's unit, of which a cell is 1 / `cells_per_unit`, in the mesh's frame.
/// `ray_out_of_range`: what is no number, no direction, a reach below 0, or further off than any
/// mesh.
inline MadeSegment segment_of(const float (&origin)[3], const float (&direction)[3], float reach,
                              float cells_per_unit) {
  const MadeSegment none = {Status::ray_out_of_range, {}};
  const int64_t fractions = detail::cell_fractions(reach, cells_per_unit);
  int32_t whole[3];
  if (fractions < 0 || fractions > int64_t{2} * kMaxRayCoordinate << 16 ||
      !detail::get_direction(direction, whole)) {
    return none;
  }
  if (detail::is_below_zero(reach)) {  // by so little that it was rounded to 0
    return none;
  }
  int64_t squared = 0;
  for (const int32_t component : whole) {
    squared += int64_t{component} * component;
  }
  const auto length = static_cast<uint32_t>(detail::square_root(detail::widened(squared)));
  int32_t from[3];
  int32_t to[3];
  for (int i = 0; i < 3; ++i) {
    const int64_t start = detail::cell_fractions(origin[i], cells_per_unit);
    const int64_t end = start + detail::way_along(fractions, whole[i], length);
    const int64_t most = detail::kMostOfSegment << 16;
    if (start < -most || start > most || end < -most || end > most) {
      return none;
    }
    from[i] = static_cast<int32_t>(detail::whole_cells(start));
    to[i] = static_cast<int32_t>(detail::whole_cells(end));
  }
  return {Status::done, {{from[0], from[1], from[2]}, {to[0], to[1], to[2]}}};
}

}  // namespace flashbvh

#endif
