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

/// pose_float.hpp turns it into the mesh's unit.
using FinePoint = flashbvh_fine_point;
using Normal = flashbvh_normal;
using Contact = flashbvh_contact;

/// What the common part of two triangles may be.
enum class ContactKind : uint8_t {
  segment = FLASHBVH_CONTACT_SEGMENT,
  coplanar = FLASHBVH_CONTACT_COPLANAR,
  degenerate = FLASHBVH_CONTACT_DEGENERATE,
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
