// Floating point, as kinematics and sensors give it: poses of a matrix or a unit quaternion, rays
// of an origin, a direction and a reach; lengths, points and contacts in the mesh's unit.
//
// Optional: firmware that does not include this header links no float code. The header calculates
// with none, either: a float is taken apart by its bits and the rest is integers. So no conversion
// is out of range, NaN and infinity are known by their bits (whatever -ffast-math assumes), and
// results are the same on every core: without an FPU, with fused multiplication, with subnormals
// flushed to zero.
//
// Where an input of a pose is no number or too large, the pose's status says so: `not_a_rotation`
// for a rotation, `translation_out_of_range` for a translation or for a `cells_per_unit` that is
// not positive and finite; the latter if both are wrong.
//
// Translations are in the mesh's unit: `cells_per_unit` is NAME_CELLS_PER_UNIT of the baked header,
// or 1 where they are in cells. Their product is rounded once, to 1/65,536 of a cell. The start of
// a ray lies within half a cell of the origin along each axis, its end within 0.51 cells of where
// direction and reach end; so at the reach the segment is at most 0.9 cells away from the ray.
//
// Stack on Cortex-M3 to M55 at -O2: a pose 352 bytes, a ray 304 bytes.
#ifndef FLASHBVH_FLOAT_HPP
#define FLASHBVH_FLOAT_HPP

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

/// B rotated and translated: its point p lies at rotation * p + translation in A's frame.
/// `rotation`: row by row, each entry rounded to 2^-30, halves away from zero; then as
/// Pose::rigid() has it, with its tolerance and its rounding to 2^-22.
inline Pose pose_of(const float (&rotation)[3][3], const float (&translation)[3],
                    float cells_per_unit) {
  return detail::make_pose(rotation, translation, cells_per_unit);
}

/// The same from 12 numbers row by row: three of the rotation and one of the translation a row.
inline Pose pose_of(const float (&matrix)[3][4], float cells_per_unit) {
  return detail::make_pose(matrix, cells_per_unit);
}

/// The same from a unit quaternion. A squared length further than kQuaternionTolerance from 1 gives
/// `not_a_rotation`; within it, the quaternion is taken as one of length 1 that was rounded, and
/// made so.
inline Pose pose_of(const UnitQuaternion& rotation, const float (&translation)[3],
                    float cells_per_unit) {
  int32_t entries[3][3] = {};
  detail::set_rotation(rotation, entries);
  return detail::make_pose(entries, translation, cells_per_unit);
}

/// NAME_CELLS_PER_UNIT of a mesh whose header is not there, as of an image. `cell_bits`:
/// Mesh::cell_bits.
inline float cells_per_unit(uint64_t cell_bits) {
  return detail::float_of(detail::cells_per_unit_bits(cell_bits));
}

/// A length in the mesh's unit as a distance in 1/256 cell (clearance.hpp): rounded down, but for a
/// rounding of the product to 1/65,536 cell. UINT32_MAX, which every query refuses, if it is
/// negative, no number or too large.
inline uint32_t fine_distance(float length, float cells_per_unit) {
  const int64_t fine = detail::cell_fractions(length, cells_per_unit) >> 8;
  return detail::is_below_zero(length) || fine >= UINT32_MAX ? UINT32_MAX
                                                             : static_cast<uint32_t>(fine);
}

/// The length of so many 1/256 cells in the mesh's unit, to the nearest float.
inline float length_in_unit(int64_t fine, uint64_t cell_bits) {
  return detail::float_of(detail::length_bits(fine, cell_bits));
}

/// A segment, or why there is none.
struct [[nodiscard]] MadeSegment {
  Status status;
  Segment segment;
};

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

using UnitPoint = flashbvh_unit_point;

/// A contact's point in the unit of mesh A, which it is reported of; each coordinate rounded once,
/// to the nearest float. A float has 24 bits, which a point 65,536 cells off takes up: past that,
/// millionths_of() (units.hpp) keeps the rest.
inline UnitPoint in_unit(const FinePoint& point, uint64_t cell_bits) {
  return {detail::float_of(detail::length_bits(point.x, cell_bits)),
          detail::float_of(detail::length_bits(point.y, cell_bits)),
          detail::float_of(detail::length_bits(point.z, cell_bits))};
}

/// Two triangles that intersect, and where.
template <class Index>
struct [[nodiscard]] UnitContact {
  Status status;  ///< of Query; after an error `yes` is true and nothing else holds
  bool yes;       ///< false: no triangles intersect, and nothing else holds
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

/// The first pair of triangles that a query finds, and where they intersect. Stack on Cortex-M3 to
/// M55 at -O2: as first_pair(); the result, 88 bytes, not counted.
template <class Index>
UnitContact<Index> first_contact(const BasicMesh<Index, Layout::post_indexed>& a,
                                 const BasicMesh<Index, Layout::post_indexed>& b,
                                 const Pose& pose) {
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

#endif
