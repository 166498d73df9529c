// Gaps along one direction from A to B, that of triangles found before: what is farther apart along
// it than a limit need not be looked at. Triangles lie in flash as they are; a box takes three
// products, where others rotate it.
#ifndef FLASHBVH_DETAIL_BOUNDS_LEAF_GAP_HPP
#define FLASHBVH_DETAIL_BOUNDS_LEAF_GAP_HPP

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/slab.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/lattice/packed_vector.hpp"
#include "flashbvh/detail/lattice/split_matrix.hpp"

namespace flashbvh::detail {

/// A direction from A to B as both lattices see it, and how far two triangles have to be apart
/// along it. What rotating it can be off by is that of a slab of A, seen from B (slab.hpp).
class LeafGap {
 public:
  /// Along no direction: nothing is apart.
  LeafGap() : on_a_{0, 0}, on_b_{0, 0}, origin_(0), squared_(1) {}

  /// `direction`: on A's lattice, of kDirectionBits. `limit`: the largest squared distance that
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

  /// Where a triangle of A ends, and one of B begins, along the direction.
  template <class Mesh>
  int32_t end_of_a(const Mesh& a, uint32_t position) const {
    return corners_of(a, position).extent(on_a_).most;
  }
  template <class Mesh>
  int32_t start_of_b(const Mesh& b, uint32_t position) const {
    return corners_of(b, position).extent(on_b_).least + origin_;
  }
  /// Whether what ends and what begins there is farther apart than the limit.
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
  int32_t origin_;    ///< of B's lattice along the direction, less what it can be off by
  uint64_t squared_;  ///< of the least gap beyond the limit, in units of the direction
};

/// The same of boxes, and of a leaf's triangles and boxes of the other tree. An end is how far
/// something reaches towards the other mesh, from -kBoundBias along each axis on: 0 to 2^30.
class SupportGap {
 public:
  SupportGap() : of_a_{0, 0, 0}, of_b_{0, 0, 0}, most_(kNothing) {}
  explicit SupportGap(const LeafGap& gap);
  /// Of a far B, along the direction of its origin: nothing is apart, but guess() guesses.
  explicit SupportGap(const Transform& transform) noexcept;
  /// Of a far B; `limit`: below 2^43, else nothing is apart.
  SupportGap(const PackedVector& direction, const Transform& transform, int64_t limit) noexcept;

  FLASHBVH_INLINE bool separates(const PackedBox& a, const PackedBox& b) const {
    return end_along(of_a_, a) + end_along(of_b_, b) <= most_;
  }
  /// Which boxes seem nearest, along the direction alone.
  uint32_t guess(const PackedBox& a, const PackedBox& b) const noexcept;
  /// Where a triangle ends, and the triangles of a leaf.
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
  /// What has to be exceeded by an end of the other side than one that ends there.
  int32_t most_beside(int32_t end) const { return most_ < end ? kNothing : most_ - end; }
  /// Whether what ends so is farther apart than the limit; and whether it may be but for what
  /// rounding the direction takes, at most, of large triangles: some cells.
  bool separates(int32_t end_a, int32_t end_b) const { return end_a + end_b <= most_; }
  bool nearly_separates(int32_t end_a, int32_t end_b) const {
    return most_ != kNothing && end_a + end_b <= most_ + kTie;
  }
  static constexpr int32_t kTie = 16 << kDirectionBits;

  /// Whether a leaf has a corner of the nearest triangle, by its vertices, and no other corner that
  /// may reach as far along the direction before it was rounded (lib/docs/derivations.md, "Ties of
  /// leaves"). Two such leaves have no triangles that are nearer.
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

  /// Where a box ends along a row.
  FLASHBVH_INLINE static int32_t end_along(const SplitRow& row, const PackedBox& box) {
    return add_products(
        add_products(add_products(0, row.positive_xy, box.upper_xy), row.negative_xy, box.lower_xy),
        row.z, box.z);
  }
  static constexpr int32_t kNothing = -1;  ///< no end is as small

 private:
  /// What rounding B's vertices moves two of them along the direction, at most.
  static constexpr int32_t kTurned = 1 << 15;

  static PackedVector direction_of(const SplitRow& row) {
    return {signed_difference(row.positive_xy, row.negative_xy), row.z_entry()};
  }

  SplitRow of_a_;
  SplitRow of_b_;  ///< of the direction back, from B to A
  int32_t most_;   ///< ends of boxes that are farther apart than the limit add up to no more
};

}  // namespace flashbvh::detail

#endif
