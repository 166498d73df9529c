// Compares triangles of two leaves where they lie in flash, along the direction that separated the
// last pair. A walk at a distance tests hundreds of pairs, and places only a few.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/leaf_gap.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "flashbvh/detail/query/proximity.hpp"
#include "flashbvh/detail/query/triangle_test.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// Within for a guard's walks, which are many, run in slices and mostly end with "no".
struct WithinAlong : Within {
  static constexpr uint32_t kPairWork = kAlongPairWork;
  static constexpr uint32_t kExpensiveWork = kPlacedPairWork;

  using StaysNear = void;

  uint32_t expensive_tests = 0;  ///< in units of kExpensiveWork

  WithinAlong() {}
  explicit WithinAlong(const Within& within) : Within(within) {}

  template <class Mesh>
  Status error_of(const Transform& transform, const Mesh& a, const Mesh& b) const {
    return transform.is_near() || !may_matter(transform, a.nodes[0].box, b.nodes[0].box)
               ? Status::done
               : Status::distance_out_of_range;
  }
  bool test(const Triangle& a, const Triangle& b) {
    ++expensive_tests;
    const int64_t limit = squared();
    if (boxes_separate(a, b, limit, direction) || directions_separate(a, b, limit, direction) ||
        planes_separate(a, b, limit) || edges_separate(a, b, limit, direction)) {
      return false;
    }
    expensive_tests += kExactPairWork / kPlacedPairWork;
    return is_within(a, b, {squared_steps(), kStepsSquared});
  }
  /// The gap along the direction that separated the last pair.
  LeafGap gap(const Transform& transform) const {
    return direction.packed != 0 ? LeafGap(scaled(direction), transform, squared()) : LeafGap();
  }

 private:
  /// Scales a direction from 10 bits to a slab's 13.
  static PackedVector scaled(const Direction& from) {
    const auto component = [&](int up) {
      return (static_cast<int32_t>(from.packed << up) >> 22) * 16;
    };
    return {join_halves(static_cast<uint16_t>(component(22)), static_cast<uint16_t>(component(12))),
            component(2)};
  }
};

/// Places only triangles that the last direction does not separate. Made for each batch of leaves,
/// so that a walk does not hold the gap.
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
    if (kept_.take(of_b)) {
      start_ = gap_.start_of_b(b_, of_b);
    }
    return true;
  }
  bool operator()(uint32_t of_a) {
    return !gap_.separates(gap_.end_of_a(a_, of_a), start_) && test(of_a);
  }

 private:
  FLASHBVH_NOINLINE bool test(uint32_t of_a) {
    const Triangle& b = kept_.placed(b_, transform_);
    Triangle a;
    translate_triangle(a_, of_a, kNoOffset, a);
    const uint32_t before = predicate_.direction.packed;
    const bool is_near = predicate_.test(a, b);
    if (predicate_.direction.packed != before) {
      turn();
    }
    return is_near;
  }
  /// Kept out of line, so that no frame below it holds another gap.
  FLASHBVH_NOINLINE void turn() {
    gap_ = predicate_.gap(transform_);
    start_ = gap_.start_of_b(b_, kept_.position());
  }

  WithinAlong& predicate_;
  const Mesh& a_;
  const Mesh& b_;
  const Transform& transform_;
  LeafGap gap_;
  KeptTriangle<Mesh> kept_;
  int32_t start_ = 0;  ///< of B's triangle, along the direction
};

}  // namespace flashbvh::detail

#pragma GCC diagnostic pop
