// The triangles of a reported pair, placed again at any later time: by their source numbers.
#ifndef FLASHBVH_PLACE_PAIR_HPP
#define FLASHBVH_PLACE_PAIR_HPP

#include <stdint.h>

#include "flashbvh/placement.hpp"
#include "flashbvh/query.hpp"

namespace flashbvh {

/// The position in the tree of a triangle of the source mesh; triangle_count if there is none.
template <class TreeType>
uint32_t position_of(const TreeType& tree, uint32_t source) {
  uint32_t position = 0;
  while (position < tree.triangle_count && tree.sources[position] != source) {
    ++position;
  }
  return position;
}

/// Where a query on `a` and `b` under `pose` has the triangles of `pair`, in cells from A's origin;
/// for contact_of(), say. False, and nothing is written, if the pose is in error, the cells differ
/// or a number isn't in its tree; whether the triangles meet is not asked. A
/// turned B that is farther off than kMaxOffset is placed at that distance, where it meets nothing.
///
/// Cost: looks through the source numbers of both trees, in flash, one by one; then prepares the
/// pose as a query does. Query::last_pair() has neither to do.
template <class TreeType>
bool place_pair(const TreeType& a, const TreeType& b, const Pose& pose,
                const TrianglePair<typename TreeType::Index>& pair, PlacedTriangle& placed_a,
                PlacedTriangle& placed_b) {
  const uint32_t of_a = position_of(a, pair.a);
  const uint32_t of_b = position_of(b, pair.b);
  if (pose.status() != Status::done || a.cell_bits != b.cell_bits || of_a == a.triangle_count ||
      of_b == b.triangle_count) {
    return false;
  }
  const Placement placement(pose, a, b, /*may_stop=*/false);
  place_translated(a, of_a, {0, 0, 0}, placed_a);
  if (placement.is_rotated()) {
    place_rotated(b, of_b, placement.rotated(), placed_b);
  } else {
    place_translated(b, of_b, placement.translated().offset, placed_b);
  }
  return true;
}

}  // namespace flashbvh

#endif
