// Where two triangles intersect: the common piece of a reported pair, and both normals.
//
// That a pair intersects is decided exactly (triangle.hpp); this says where, for those who draw it,
// measure it or push the bodies apart. A query never pays for it: it is asked per pair.
#ifndef FLASHBVH_CONTACT_HPP
#define FLASHBVH_CONTACT_HPP

#include <stdint.h>

#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/query.hpp"

namespace flashbvh {

/// Steps of a FinePoint in a cell.
constexpr int32_t kFineOne = 256;

/// Largest difference along one axis between two corners of one triangle, in cells. Meshes keep
/// within it under any pose: 2 * 16,383 * sqrt(3) = 56,753, and a cell for rounding.
constexpr int32_t kMaxContactSpan = 57000;
/// The same between any two corners of two triangles: what transformed vertices keep to.
constexpr int32_t kMaxContactDistance = 160000;
/// Largest magnitude of a corner's coordinate, in cells: that of an origin, and a mesh's extent.
constexpr int32_t kMaxContactCoordinate = (1 << 29) + kMaxContactDistance / 2;

/// A point in the frame of mesh A as it was drawn, in 1/256 cell: within +-2^38. pose_float.hpp
/// turns it into the mesh's unit.
struct FinePoint {
  int64_t x;
  int64_t y;
  int64_t z;
};

/// (p1 - p0) x (p2 - p0) of a triangle p0, p1, p2: exact, in square cells, twice the area long, not
/// normalised. Each component is within +-57,000^2, below 2^32. Zero for a triangle without area.
/// It points outwards where the mesh winds its triangles counter-clockwise seen from outside.
struct Normal {
  int64_t x;
  int64_t y;
  int64_t z;
};

/// What the common part of two triangles may be.
enum class ContactKind : uint8_t {
  segment = 0,     ///< two planes that differ: the common part is a segment or a point
  coplanar = 1,    ///< one plane: the common part is an area, a segment or a point
  degenerate = 2,  ///< a triangle has no area, its normal is zero: a segment or a point
};

/// The common part of two triangles.
///
/// `ends` are two corners of the common part that are farthest apart, distance being the largest
/// difference along one axis: of a segment its two ends, of an area two opposite corners. Each
/// coordinate is within 0.53 / 256 cell of the exact one, and equal to it where that is a multiple
/// of 1/256, as at a corner of a triangle. Where the triangles have only one point in common, both
/// ends are equal. ends[0] comes before ends[1] by x, then y, then z.
struct Contact {
  ContactKind kind;
  FinePoint ends[2];
  Normal normal_a;
  Normal normal_b;
};

/// The common part of `a` and `b`, which intersect.
///
/// The order of corners and of arguments changes the normals, as their definition says, and nothing
/// else; translating both triangles by whole cells translates the ends alike. Each triangle spans
/// at most kMaxContactSpan along each axis, both at most kMaxContactDistance, and coordinates are
/// within +-kMaxContactCoordinate, as those of every pair that a query reports are; this is not
/// checked. Of triangles within these bounds that do not intersect, the answer is two meaningless
/// points and correct normals.
///
/// Cost in instructions on a Cortex-M4 at -O2: 1,800 for two planes that cross, 5,000 on average
/// and at most 8,500 for coplanar triangles (tests/budget/contact_cost_test.cpp prints them).
/// Stack: 280 bytes on Cortex-M3 to M55 at -O2, the contact itself, 104 bytes, not counted.
///
/// Source: the common line as in Guigue and Devillers (triangle.hpp).
[[nodiscard]] Contact contact_of(const Triangle& a, const Triangle& b) noexcept;

/// The same of the pair that `query` reported last: where Query::last_pair() may be asked.
template <class Query>
[[nodiscard]] Contact contact_of_last(const Query& query) {
  Triangle a;
  Triangle b;
  query.last_pair(a, b);
  return contact_of(a, b);
}

/// The position in the mesh of a triangle, by its id; triangle_count if there is none.
template <class Mesh>
uint32_t position_of(const Mesh& mesh, uint32_t id) {
  uint32_t position = 0;
  while (position < mesh.triangle_count && mesh.triangle_ids[position] != id) {
    ++position;
  }
  return position;
}

/// The triangles of a reported pair at any later time, where a query on `a` and `b` under `pose`
/// has them: in A's frame, in cells, for contact_of(). False, and nothing is written, if the pose
/// is in error, the cells differ or an id isn't in its mesh; whether the triangles intersect is not
/// asked. A rotated B that is farther off than 48,000 cells is put at that distance, where it
/// intersects nothing.
///
/// Cost: looks through the ids of both meshes, in flash, one by one; then prepares the pose as a
/// query does. Query::last_pair() has neither to do.
template <class Mesh>
[[nodiscard]] bool transform_pair(const Mesh& a, const Mesh& b, const Pose& pose,
                                  const TrianglePair<typename Mesh::Index>& pair,
                                  Triangle& triangle_a, Triangle& triangle_b) {
  const uint32_t of_a = position_of(a, pair.a);
  const uint32_t of_b = position_of(b, pair.b);
  if (pose.status() != Status::done || a.cell_bits != b.cell_bits || of_a == a.triangle_count ||
      of_b == b.triangle_count) {
    return false;
  }
  const detail::Transform transform(pose, a, b, /*may_stop=*/false);
  detail::place_pair(a, of_a, b, of_b, transform, triangle_a, triangle_b);
  return true;
}

}  // namespace flashbvh

#endif
