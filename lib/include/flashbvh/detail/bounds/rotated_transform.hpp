// B's lattice under a pose that rotates it, seen from A's lattice: places B's vertices, and has the
// numbers of the box test for both meshes (box_rotated.hpp).
//
// A vertex p goes to floor(R p + o + 1/2). R is the pose's rotation with 22 fraction bits; o has 14
// fraction bits and includes both meshes' origins. This point is a function of p alone, so a
// transformed mesh keeps its edges and corners together. Each coordinate is within 1/2 + 1/100 cell
// of the exact result of the pose's numbers (lib/docs/derivations.md, "Poses").
//
// All factors have 16 bits and all sums 32, so every core can compute them.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/pose.hpp"

namespace flashbvh::detail {

/// Offsets are clamped to +-this, in cells. Beyond 16,383 * (1 + sqrt(3)) + 1 cells no vertex of B
/// can be near A, so clamping changes no answer. It keeps every sum of the box test in 32 bits.
constexpr int32_t kMaxOffset = 48000;

/// The largest offset of predicates of distance, in cells: from kMaxOffset on B is rotated about
/// its origin, and then moved by whole cells.
constexpr int32_t kMaxFarOffset = 1 << 20;

/// Start values of the sums of products for a rotated box's bounds along an axis: the upper and the
/// negated lower bound. kSplitOne is a cell; biases, rounding and margin are included.
struct BoxTestStart {
  int32_t upper;
  int32_t lower;
};

/// The other lattice's origin along the axis: both values contain it, one negated, and otherwise
/// equal terms.
inline int32_t offset_of(const BoxTestStart& start) {
  return (start.upper - start.lower) >> 1;
}

/// 88 bytes on a 32-bit core; trivial, so that it can share memory with a TranslatedTransform.
struct RotatedTransform {
  const RotationMatrix* matrix;  ///< the pose's: its rows rotate boxes of B
  SplitMatrix columns;           ///< rotate boxes of A
  BoxTestStart on_a[3];          ///< boxes of B on A's axes
  union {
    BoxTestStart on_b[3];  ///< boxes of A on B's axes
    Point far_offset;      ///< of a far B, where no rotated box of A is used
  };

  /// Sets all members. The origins are the meshes', within +-2^29 cells; `root_b` contains all
  /// vertices that will be transformed. False, with unusable members, if `may_stop` and meshes with
  /// these root boxes are too far apart to intersect; true in doubt. The pose rotates, and outlives
  /// this.
  bool prepare(const Pose& pose, const int32_t (&origin_a)[3], const PackedBox& root_a,
               const int32_t (&origin_b)[3], const PackedBox& root_b, bool may_stop);

  /// Prepares the rotation of boxes, once no axis of A separates the roots. False as prepare().
  FLASHBVH_NOINLINE bool prepare_boxes(const PackedBox& root_a, const PackedBox& root_b,
                                       bool may_stop);

  /// In cells from A's origin, or from `far_offset`: within +-80,000.
  Point transform(const Vertex& v) const;
  void transform(const Vertex& u, const Vertex& v, const Vertex& w, Triangle& triangle) const;
};

}  // namespace flashbvh::detail
