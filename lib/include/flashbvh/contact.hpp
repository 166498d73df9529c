// The triangles of a reported pair: their contact, and their corners at a later time.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/query.hpp"
#include "flashbvh/triangle.hpp"

namespace flashbvh {

/// Returns contact_of() for the pair that `query` reported last. Valid when Query::last_pair() is.
template <class Query>
[[nodiscard]] Contact contact_of_last(const Query& query) {
  Triangle a;
  Triangle b;
  query.last_pair(a, b);
  return contact_of(a, b);
}

/// Returns the slot of the triangle with this id; triangle_count if there is none.
template <class Mesh>
uint32_t slot_of(const Mesh& mesh, uint32_t id) {
  uint32_t slot = 0;
  while (slot < mesh.triangle_count && mesh.triangle_ids[slot] != id) {
    ++slot;
  }
  return slot;
}

/// Recomputes the triangles of a reported pair at any later time, in cells of A's frame, for
/// contact_of(). They equal those of a query on `a` and `b` under `pose`. Returns false, and writes
/// nothing, if the pose has an error, the cells differ or an id is not in its mesh. Does not test
/// whether the triangles intersect. A rotated B more than 48,000 cells away is placed at that
/// distance, where it intersects nothing.
///
/// Cost: searches the ids of both meshes in flash, one by one, then prepares the pose as a query
/// does. Query::last_pair() needs neither.
template <class Mesh>
[[nodiscard]] bool transform_pair(const Mesh& a, const Mesh& b, const Pose& pose,
                                  const TrianglePair<typename Mesh::Index>& pair,
                                  Triangle& triangle_a, Triangle& triangle_b) {
  const uint32_t of_a = slot_of(a, pair.a);
  const uint32_t of_b = slot_of(b, pair.b);
  if (pose.status() != Status::done || !detail::have_one_cell(a, b) || of_a == a.triangle_count ||
      of_b == b.triangle_count) {
    return false;
  }
  const detail::Transform transform(pose, a, b, /*may_stop=*/false);
  detail::place_pair(a, of_a, b, of_b, transform, triangle_a, triangle_b);
  return true;
}

}  // namespace flashbvh
