// Floats from kinematics and sensors: poses from a matrix or a unit quaternion, rays from an
// origin, a direction and a reach; lengths, points and contacts in the mesh's unit.
//
// Firmware that calls nothing of this header links no float code. The header itself uses
// no float arithmetic: it splits a float into its bits and calculates in integers. So no conversion
// is out of range, and NaN and infinity are detected by their bits (despite -ffast-math). Results
// are equal on every core: without an FPU, with fused multiplication, with subnormals flushed to
// zero.
//
// A pose's status has the error if an input is not finite or too large: `not_a_rotation` for a
// rotation, `translation_out_of_range` for a translation. A `cells_per_unit` that is not positive
// and finite also gives the latter, as do two errors.
//
// Translations are in the mesh's unit. `cells_per_unit` is NAME_CELLS_PER_UNIT of the baked header,
// or 1 for cells. Their product is rounded once, to 1/65,536 cell. A ray starts within half a cell
// of the origin along each axis and ends within 0.51 cells of the exact end. So at the reach the
// segment is at most 0.9 cells away from the ray.
//
// Stack on Cortex-M3 to M55 at -O2: a pose 352 bytes, a ray 304 bytes.
#pragma once

#include <stdint.h>

#include "flashbvh/collide.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/detail/lattice/float_parts.hpp"
#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/detail/query/ray_parts.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/ray.hpp"
#include "flashbvh/units.hpp"

namespace flashbvh {

/// Returns a pose that rotates and translates B: point p of B is at rotation * p + translation in
/// A's frame. `rotation`: row by row, each entry rounded to 2^-30, halves away from zero; then as
/// in Pose::rigid(), with its tolerance and its rounding to 2^-22.
inline Pose pose_of(const float (&rotation)[3][3], const float (&translation)[3],
                    float cells_per_unit) {
  return detail::pose_of_parts(rotation, translation, cells_per_unit);
}

/// Returns a pose from 12 numbers row by row: three of the rotation and one of the translation a
/// row.
inline Pose pose_of(const float (&matrix)[3][4], float cells_per_unit) {
  return detail::pose_of_parts(matrix, cells_per_unit);
}

/// Returns a pose from a unit quaternion. `not_a_rotation`: its squared length differs from 1 by
/// more than kQuaternionTolerance. Within the tolerance, the quaternion is normalised.
inline Pose pose_of(const UnitQuaternion& rotation, const float (&translation)[3],
                    float cells_per_unit) {
  int32_t entries[3][3] = {};
  detail::set_rotation(rotation, entries);
  return detail::pose_of_parts(entries, translation, cells_per_unit);
}

/// Returns NAME_CELLS_PER_UNIT of a mesh without its header, such as an image: the nearest float,
/// but a power of two only if it is exact. `cell_bits`: Mesh::cell_bits.
inline float cells_per_unit(uint64_t cell_bits) {
  return detail::float_of(detail::cells_per_unit_bits(cell_bits));
}

/// Converts a length in the mesh's unit, and adds `margin`. The result is never below the exact
/// length in the mesh's cells, and exceeds it by less than 2^-22 of it and 1/256 cell; it is exact
/// if cells per unit are a power of two and the length is a multiple of 1/256 cell. UINT32_MAX,
/// which every query rejects: the length is negative, not a number or too large.
///
/// Rounding up is safe for each parameter of the library: more pairs are near, guards stop earlier,
/// and an obstacle has moved further.
inline FineLength fine_length_rounded_up(float length, float cells_per_unit,
                                         FineLength margin = {0}) {
  const uint64_t fine = uint64_t{detail::fine_steps_above(length, cells_per_unit)} + margin.count;
  return {fine < UINT32_MAX ? static_cast<uint32_t>(fine) : UINT32_MAX};
}

/// Returns a length in the mesh's unit, to the nearest float. `fine`: in 1/256 cell, within +-2^39,
/// as every query's result is.
inline float length_in_unit(int64_t fine, uint64_t cell_bits) {
  return detail::float_of(detail::length_bits(fine, cell_bits));
}

/// A segment, or the error.
struct [[nodiscard]] MadeSegment {
  Status status;
  Segment segment;
};

/// Returns the segment from `origin` along `direction`, of any length but 0, up to `reach`. Origin
/// and reach are in the mesh's unit and frame; a cell is 1 / `cells_per_unit`. `ray_out_of_range`:
/// an input is not a number, the direction is zero, the reach is below 0, or an end is farther away
/// than any mesh.
inline MadeSegment segment_of(const float (&origin)[3], const float (&direction)[3], float reach,
                              float cells_per_unit) {
  const MadeSegment none = {Status::ray_out_of_range, {}};
  const int64_t fractions = detail::cell_fractions(reach, cells_per_unit);
  int32_t whole[3];
  if (fractions < 0 || fractions > int64_t{2} * kMaxRayCoordinate << 16 ||
      !detail::get_direction(direction, whole)) {
    return none;
  }
  if (detail::is_below_zero(reach)) {  // below 0, but rounded to 0
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

using UnitPoint = flashbvh_unit_point;

/// Converts a contact's point to the unit of mesh A; each coordinate is rounded once, to the
/// nearest float. A float's 24 bits resolve 1/256 cell up to 65,536 cells away; millionths_of()
/// (units.hpp) keeps the rest farther away.
inline UnitPoint in_unit(const FinePoint& point, uint64_t cell_bits) {
  return {detail::float_of(detail::length_bits(point.x, cell_bits)),
          detail::float_of(detail::length_bits(point.y, cell_bits)),
          detail::float_of(detail::length_bits(point.z, cell_bits))};
}

/// Two triangles that intersect, and their common part.
template <class Index>
struct [[nodiscard]] UnitContact {
  Status status;  ///< as of Query; after an error `yes` is true and no other field is valid
  bool yes;       ///< false: no triangles intersect, and no other field is valid
  TrianglePair<Index> triangles;
  UnitPoint ends[2];  ///< of the common part (contact_of()), in A's frame and unit
  Normal normal_a;
  Normal normal_b;
};

namespace detail {

/// Kept out of line so that its frame is gone while the query runs.
template <class Index>
FLASHBVH_NOINLINE void put_contact(const DefaultQuery<Index>& query, uint64_t cell_bits,
                                   UnitContact<Index>& found) {
  const Contact contact = contact_of_last(query);
  found.status = Status::done;
  found.ends[0] = in_unit(contact.ends[0], cell_bits);
  found.ends[1] = in_unit(contact.ends[1], cell_bits);
  found.normal_a = contact.normal_a;
  found.normal_b = contact.normal_b;
}

}  // namespace detail

/// Returns the first pair of triangles that a query finds, and their intersection. Stack on
/// Cortex-M3 to M55 at -O2: as first_pair(), without the result's 88 bytes.
template <class Index>
UnitContact<Index> contact_at(const BasicMesh<Index, Layout::post_indexed>& a,
                              const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose) {
  UnitContact<Index> found = {};
  DefaultQuery<Index> query(a, b, pose);
  found.status = query.run(UINT32_MAX, &found.triangles, 1).status;
  found.yes = found.status != Status::done;
  if (found.status == Status::full) {
    detail::put_contact(query, a.cell_bits, found);
  }
  return found;
}

}  // namespace flashbvh
