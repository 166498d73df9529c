// The test whether a box of A and a turned box of B overlap: the face axes of both.
//
// With doubled centre c = upper + lower and doubled half extents h = upper - lower of a box of B,
// its placed vertices lie, on A's axis i, within
//     (R c)_i / 2 + o_i  +-  ((|R| h)_i / 2 + 1/2 + m)
// where m, the box margin, is what the rotation of the boxes lacks of that of the vertices. Rounded
// down to cells these bounds are an axis-aligned box, which is kept while B's node stays the same;
// A's box is tested against it by packed sums of bounds.
//
// Only where they overlap, the same on B's axis j, whose direction is the column R_j: with D, the
// centre of B's box from that of A's, the boxes are apart if
//     |R_j . D|  >  (|R_j| . h_A) / 2 + h_B,j / 2 + n
// where n, the axis margin, is what rounding vertices, and columns that are not quite orthogonal,
// can add. Both margins are derived in lib/docs/design.md, Rotation.
//
// Source: Gottschalk, Lin, Manocha, "OBBTree", SIGGRAPH 1996, for the axes and their order. The
// nine cross products of edges are left out: fewer pairs are visited with them, but more
// instructions executed (lib/docs/design.md).
#ifndef FLASHBVH_BOX_ROTATED_HPP
#define FLASHBVH_BOX_ROTATED_HPP

#include <stdint.h>

#include "flashbvh/box_packed.hpp"
#include "flashbvh/rotated_placement.hpp"

namespace flashbvh {

/// Tests boxes of A against boxes of B under a rotation; lives as long as a run of a walk.
/// 52 bytes on a 32-bit core.
class RotatedOverlap {
 public:
  /// `placement` outlives this.
  explicit RotatedOverlap(const RotatedPlacement& placement);

  /// False only if no placed triangle of a subtree with box `b` meets one of a subtree with box
  /// `a`. Answers depend on the boxes alone, not on what was asked before.
  bool overlap(const PackedBox& a, const PackedBox& b);

 private:
  void place(const PackedBox& b);
  bool apart_along_b(const PackedBox& a, const PackedBox& b) const;

  const RotatedPlacement* placement_;
  PackedMatrix absolute_;        ///< of the rotation
  const PackedBox* placed_for_;  ///< the box of B that is placed, null at first
  PackedBox placed_;             ///< its bounds on A's axes
  int32_t centre_[3];            ///< its centre, kPlacementOne is one cell
};

/// What a walk takes: a handle to the test.
struct RotatedTest {
  RotatedOverlap* test;
  bool operator()(const PackedBox& a, const PackedBox& b) const { return test->overlap(a, b); }
};

}  // namespace flashbvh

#endif
