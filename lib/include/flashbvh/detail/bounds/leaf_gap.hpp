// Gaps along one direction from A to B, given by triangles found before. Boxes and triangles that
// are farther apart along it than a limit are rejected. Triangles are read from flash unplaced; a
// box takes three products instead of a rotation.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/slab.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/lattice/packed_vector.hpp"
#include "flashbvh/detail/lattice/split_matrix.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// A direction from A to B in both lattices, and the gap along it that rejects two triangles. The
/// margin for rotating the direction is that of a slab of A, seen from B (slab.hpp).
class LeafGap {
 public:
  /// No direction: separates nothing.
  LeafGap() : on_a_{0, 0}, on_b_{0, 0}, origin_(0), squared_(1) {}

  /// `direction`: on A's lattice, with kDirectionBits. `limit`: the largest squared distance that
  /// still matters, below 2^35.
  LeafGap(const PackedVector& direction, const Transform& transform, int64_t limit)
      : on_a_(direction), squared_(static_cast<uint64_t>(limit + 1) * squared(on_a_)) {
    Slab slab;
    slab.begin(on_a_, {0, 0});
    if (transform.is_rotated()) {
      slab.rotate(transform, Side::a);
    } else {
      slab.translate(transform.translated().offset, Side::a);
    }
    on_b_ = slab.seen_direction();
    origin_ = slab.least_lower() - slab.row().sum() * kBoundBias;
  }

  /// The end of a triangle of A, and the start of a triangle of B, along the direction.
  template <class Mesh>
  int32_t end_of_a(const Mesh& a, uint32_t position) const {
    return corners_of(a, position).extent(on_a_).most;
  }
  template <class Mesh>
  int32_t start_of_b(const Mesh& b, uint32_t position) const {
    return corners_of(b, position).extent(on_b_).least + origin_;
  }
  /// True if an end of A and a start of B are farther apart than the limit.
  bool separates(int32_t end_of_a, int32_t start_of_b) const {
    if (start_of_b <= end_of_a) {
      return false;
    }
    const uint64_t gap = static_cast<uint32_t>(start_of_b) - static_cast<uint32_t>(end_of_a);
    return gap * gap >= squared_;
  }

 private:
  friend class SupportGap;

  template <class Mesh>
  FLASHBVH_INLINE static PackedTriangle corners_of(const Mesh& mesh, uint32_t position) {
    const auto& corner = mesh.triangles[position].corner;
    const auto at = [&](int i) { return PackedVector::of(mesh.vertices[corner[i]]); };
    return {at(0), at(1), at(2)};
  }

  PackedVector on_a_;
  PackedVector on_b_;
  int32_t origin_;    ///< of B's lattice along the direction, less the margin
  uint64_t squared_;  ///< least squared gap beyond the limit, in units of the direction
};

/// LeafGap for boxes, and for a leaf's triangles and boxes of the other tree. An end is the
/// farthest extent towards the other mesh, counted from -kBoundBias along each axis: 0 to 2^30.
class SupportGap {
 public:
  SupportGap() : of_a_{0, 0, 0}, of_b_{0, 0, 0}, most_(kNothing) {}
  explicit SupportGap(const LeafGap& gap);
  /// For a far B, along the direction of its origin: separates nothing; only guess() is of use.
  explicit SupportGap(const Transform& transform) noexcept;
  /// For a far B. `limit`: below 2^43, else this separates nothing.
  SupportGap(const PackedVector& direction, const Transform& transform, int64_t limit) noexcept;

  FLASHBVH_INLINE bool separates(const PackedBox& a, const PackedBox& b) const {
    return end_along(of_a_, a) + end_along(of_b_, b) <= most_;
  }
  /// Smaller for boxes that seem nearer, along the direction alone.
  uint32_t guess(const PackedBox& a, const PackedBox& b) const noexcept;
  /// The end of a triangle, and that of a leaf's triangles.
  template <class Mesh>
  int32_t end_of_triangle(const Mesh& mesh, Side side, uint32_t position) const {
    const SplitRow& row = side == Side::a ? of_a_ : of_b_;
    return LeafGap::corners_of(mesh, position).extent(direction_of(row)).most +
           row.sum() * kBoundBias;
  }
  template <class Mesh>
  int32_t end_of(const Mesh& mesh, Side side, uint32_t leaf) const {
    const SplitRow& row = side == Side::a ? of_a_ : of_b_;
    const PackedVector along = direction_of(row);
    int32_t end = INT32_MIN;
    const uint32_t last = mesh.end_triangle(leaf);
    for (uint32_t i = mesh.first_triangle(leaf); i < last; ++i) {
      const int32_t own = LeafGap::corners_of(mesh, i).extent(along).most;
      end = own > end ? own : end;
    }
    return end + row.sum() * kBoundBias;
  }
  /// The end that the other side must exceed to matter, if this side ends at `end`.
  int32_t most_beside(int32_t end) const { return most_ < end ? kNothing : most_ - end; }
  /// True if these ends are farther apart than the limit. nearly_separates() also accepts the most
  /// that rounding the direction takes from large triangles: some cells.
  bool separates(int32_t end_a, int32_t end_b) const { return end_a + end_b <= most_; }
  bool nearly_separates(int32_t end_a, int32_t end_b) const {
    return most_ != kNothing && end_a + end_b <= most_ + kTie;
  }
  static constexpr int32_t kTie = 16 << kDirectionBits;

  /// True if a leaf has a corner of the nearest triangle, and no other corner may reach as far
  /// along the unrounded direction. `nearest`: vertices of the nearest triangle. Two such leaves
  /// have no nearer triangles (lib/docs/derivations.md, "Ties of leaves").
  template <class Mesh, class Node, class Index>
  bool ties_alone(const Mesh& mesh, Side side, const Node& node, const Index (&nearest)[3]) const {
    const PackedVector along = direction_of(side == Side::a ? of_a_ : of_b_);
    constexpr int32_t none = -(1 << 30);
    int32_t tie = none;
    int32_t other = none;
    const auto* corner = mesh.triangles[mesh.first_triangle(node.leaf())].corner;
    const auto* const end = mesh.triangles[mesh.end_triangle(node.leaf())].corner;
    for (; corner != end; ++corner) {
      const int32_t at = dot(along, PackedVector::of(mesh.vertices[*corner]));
      const bool is_tie = *corner == nearest[0] || *corner == nearest[1] || *corner == nearest[2];
      int32_t& most = is_tie ? tie : other;
      most = at > most ? at : most;
    }
    const auto span = static_cast<int32_t>(extent(node.box));
    return other <= tie - (side == Side::a ? span : 3 * span + kTurned);
  }
  const SplitRow& row_beside(Side side) const { return side == Side::a ? of_b_ : of_a_; }

  /// The end of a box along a row.
  FLASHBVH_INLINE static int32_t end_along(const SplitRow& row, const PackedBox& box) {
    return add_products(
        add_products(add_products(0, row.positive_xy, box.upper_xy), row.negative_xy, box.lower_xy),
        row.z, box.z);
  }
  static constexpr int32_t kNothing = -1;  ///< no end is as small

 private:
  /// The most that rounding two vertices of B changes their difference along the direction.
  static constexpr int32_t kTurned = 1 << 15;

  static PackedVector direction_of(const SplitRow& row) {
    return {signed_difference(row.positive_xy, row.negative_xy), row.z_entry()};
  }

  SplitRow of_a_;
  SplitRow of_b_;  ///< of the reversed direction, from B to A
  int32_t most_;   ///< ends of boxes that are farther apart than the limit add up to no more
};

}  // namespace flashbvh::detail

#pragma GCC diagnostic pop
