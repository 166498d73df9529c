// The overlap test of a box of A and a rotated box of B, on the face axes of both.
//
// On A's axis i the transformed vertices of a box of B lie between
//     sum_j R_ij * (upper_j where R_ij > 0, else lower_j) + o_i    above, and the same form below.
// These bounds are widened by half a cell, as vertices are rounded, and by the error of R's 14 bits
// against the vertices' 22. Rounded to whole cells they are an axis-aligned box on A's lattice.
// Rotated the other way, a box of A becomes a box on B's lattice, widened by the errors of rounded
// vertices and of columns that are not quite orthogonal. The boxes are disjoint if either rotated
// box is disjoint from the other box, which three packed sums of bounds decide. Rounding the bounds
// to whole cells loses nothing, since they are compared with whole cells. lib/docs/derivations.md,
// "Rotated boxes", derives the margins.
//
// A rotated box is kept until another box of its tree is rotated: a walk moves in one tree at a
// time. The axes whose rotated box is current go first; a rejection there costs no rotation at all.
//
// Source: Gottschalk, Lin, Manocha, "OBBTree", SIGGRAPH 1996, for the separating axes. The nine
// cross products of edges are left out: they save visits, but execute more instructions in all
// (lib/docs/decisions.md).
#pragma once

#include <stdint.h>

#include "flashbvh/detail/bounds/rotated_transform.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"

namespace flashbvh::detail {

#if defined(__SSE2__) && !defined(FLASHBVH_PORTABLE)
#define FLASHBVH_ROTATE_SSE2 1

/// The rotation of a box, one axis per lane.
struct alignas(16) BoxRotation {
  uint32_t positive_xy[4];
  uint32_t negative_xy[4];
  uint32_t z[4];
  int32_t upper[4];
  int32_t lower[4];

  BoxRotation(const SplitMatrix& matrix, const BoxTestStart* starts)
      : positive_xy(), negative_xy(), z(), upper(), lower() {
    for (int i = 0; i < 3; ++i) {
      positive_xy[i] = matrix.row[i].positive_xy;
      negative_xy[i] = matrix.row[i].negative_xy;
      z[i] = matrix.row[i].z;
      upper[i] = starts[i].upper;
      lower[i] = starts[i].lower;
    }
  }
};

#else

/// The rotation of a box: a matrix, and the start values of the sums of its three axes.
struct BoxRotation {
  const SplitMatrix* matrix;
  const BoxTestStart* starts;

  BoxRotation(const SplitMatrix& by, const BoxTestStart* from) : matrix(&by), starts(from) {}
};

#endif

/// A box seen from the other lattice. 24 bytes.
struct RotatedBox {
  PackedBox bounds;
  const PackedBox* source;  ///< the box that was rotated, null at first
  BoxRotation by;
};

/// Tests boxes of A against boxes of B under a rotation; lives as long as a run of a walk. 48 bytes
/// on a 32-bit core.
class RotatedBoxTest {
 public:
  /// `transform` and its pose outlive this and do not change: parts may be copied here.
  explicit RotatedBoxTest(const RotatedTransform& transform)
      : a_{{0, 0, 0}, nullptr, {transform.columns, transform.on_b}},
        b_{{0, 0, 0}, nullptr, {transform.matrix->rows, transform.on_a}} {}

  /// False only if no transformed triangle of a subtree with box `b` intersects one of a subtree
  /// with box `a`. Answers depend on the boxes alone, not on earlier calls. But a box is identified
  /// by its address, and must not change while this lives.
  bool operator()(const PackedBox& a, const PackedBox& b) { return gap(a, b) == 0; }

  /// Lower limits for the packed words of a box of B, to overlap `a` on B's lattice. window_of_b():
  /// of a box of A, on A's lattice. The argument must be of the last overlapping pair, or kept;
  /// every box reaches the limits of another argument.
  PackedTriple window_of_a(const PackedBox& a) const { return window(a_, a); }
  PackedTriple window_of_b(const PackedBox& b) const { return window(b_, b); }
  /// The same, of any box. `of_a`: it is one of A.
  static PackedTriple window_of(const RotatedTransform& transform, bool of_a, const PackedBox& box);
  void keep_a(const PackedBox& a) { keep(a_, a); }
  void keep_b(const PackedBox& b) { keep(b_, b); }

 private:
  static PackedTriple window(const RotatedBox& kept, const PackedBox& box);
  static void keep(RotatedBox& kept, const PackedBox& box);

  /// 0 if the boxes overlap.
  uint32_t gap(const PackedBox& a, const PackedBox& b);

  RotatedBox a_;  ///< a box of A, seen from B
  RotatedBox b_;
};

}  // namespace flashbvh::detail
