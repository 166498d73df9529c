// Compares triangles of two leaves where they lie in flash, along the direction that separated the
// last two: a walk at a distance tests hundreds of pairs, and places only a few.
#ifndef FLASHBVH_DETAIL_QUERY_LEAF_GAP_HPP
#define FLASHBVH_DETAIL_QUERY_LEAF_GAP_HPP

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/slab.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/lattice/packed_vector.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "flashbvh/detail/query/proximity.hpp"
#include "flashbvh/detail/query/triangle_test.hpp"

namespace flashbvh::detail {

/// A direction as both lattices see it, and how far two triangles have to be apart along it. What
/// rotating it can be off by is that of a slab of A, seen from B (slab.hpp).
class LeafGap {
 public:
  /// Along no direction: nothing is apart.
  LeafGap() : on_a_{0, 0}, on_b_{0, 0}, origin_(0), squared_(1) {}

  /// `limit`: the largest squared distance that still matters.
  LeafGap(const Direction& direction, const Transform& transform, int64_t limit)
      : on_a_(scaled(direction)), squared_(static_cast<uint64_t>(limit + 1) * squared(on_a_)) {
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
  /// From 10 bits to the 13 of a slab's.
  static PackedVector scaled(const Direction& direction) {
    const auto component = [&](int up) {
      return (static_cast<int32_t>(direction.packed << up) >> 22) * 16;
    };
    return {join_halves(static_cast<uint16_t>(component(22)), static_cast<uint16_t>(component(12))),
            component(2)};
  }
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

/// The same question as Within, for walks that a guard takes many times: in slices, of which most
/// end with "no".
struct WithinAlong : Within {
  static constexpr uint32_t kPairWork = kAlongPairWork;
  static constexpr uint32_t kDearWork = kPlacedPairWork;

  uint32_t dear_tests = 0;  ///< in kDearWork

  WithinAlong() {}
  explicit WithinAlong(const Within& within) : Within(within) {}

  bool test(const Triangle& a, const Triangle& b) {
    ++dear_tests;
    const int64_t limit = squared();
    if (boxes_separate(a, b, limit, direction) || directions_separate(a, b, limit, direction) ||
        planes_separate(a, b, limit) || edges_separate(a, b, limit, direction)) {
      return false;
    }
    dear_tests += kExactPairWork / kPlacedPairWork;
    return is_within(a, b, {squared_steps(), kStepsSquared});
  }
  /// Along what separated the last two.
  LeafGap gap(const Transform& transform) const {
    return direction.packed != 0 ? LeafGap(direction, transform, squared()) : LeafGap();
  }
};

/// Triangles are placed that the last direction does not separate. Made for each batch of leaves,
/// so that a walk does without the gap.
template <class Mesh>
class TriangleTest<WithinAlong, Mesh, false> {
 public:
  TriangleTest(WithinAlong& predicate, const Mesh& a, const Mesh& b, const Transform& transform)
      : predicate_(predicate),
        a_(a),
        b_(b),
        transform_(transform),
        gap_(predicate.gap(transform)) {}

  bool take_b(uint32_t of_b, const PackedBox* /*box_a*/) {
    if (of_b != kept_) {
      kept_ = of_b;
      is_placed_ = false;
      start_ = gap_.start_of_b(b_, of_b);
    }
    return true;
  }
  bool operator()(uint32_t of_a) {
    return !gap_.separates(gap_.end_of_a(a_, of_a), start_) && test(of_a);
  }

 private:
  FLASHBVH_NOINLINE bool test(uint32_t of_a) {
    if (!is_placed_) {
      is_placed_ = true;
      transform_triangle(b_, kept_, transform_, kept_b_);
    }
    Triangle a;
    translate_triangle(a_, of_a, kNoOffset, a);
    const uint32_t before = predicate_.direction.packed;
    const bool is_near = predicate_.test(a, kept_b_);
    if (predicate_.direction.packed != before) {
      turn();
    }
    return is_near;
  }
  /// Apart, so that no frame below it holds another gap.
  FLASHBVH_NOINLINE void turn() {
    gap_ = predicate_.gap(transform_);
    start_ = gap_.start_of_b(b_, kept_);
  }

  WithinAlong& predicate_;
  const Mesh& a_;
  const Mesh& b_;
  const Transform& transform_;
  LeafGap gap_;
  uint32_t kept_ = UINT32_MAX;
  int32_t start_ = 0;  ///< of B's triangle, along the direction
  bool is_placed_ = false;
  Triangle kept_b_;
};

}  // namespace flashbvh::detail

#endif
