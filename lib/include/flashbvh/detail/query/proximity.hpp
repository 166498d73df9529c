// The predicate of bands: triangles within a distance of each other.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/bounds/gap.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "flashbvh/detail/walk/proximity_planes.hpp"
#include "flashbvh/status.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// The common part of predicates of distance: box tests of gaps, without widening.
struct ProximityPredicate {
  /// A limit of squared distances between far triangles. Nearer triangles differ by less than 2^18
  /// cells, and along 12 bits of a direction by less than 32 bits hold.
  static constexpr int64_t kMostFarLimit = int64_t{1} << 32;
  using KeepsBound = void;
  static constexpr bool kAlwaysKeepsBound = false;
  static constexpr bool kIntersects = false;
  template <class Mesh>
  using Shapes = ProximityPlanes<Mesh>;
  static constexpr bool kDisjointRootsEnd = false;
};

/// Triangles with points within a distance; an equal distance is within.
struct Within : ProximityPredicate {
  static constexpr uint32_t kBatch = 4;
  static constexpr uint32_t kPairWork = kNearPairWork;
  static constexpr uint32_t kExpensiveWork = kExpensivePairWork;
  static constexpr bool kKeepsShapes = false;
  /// Sub-cells per cell: a distance counts in 1/256 cell.
  static constexpr uint32_t kSteps = 256;
  static constexpr uint32_t kStepsSquared = kSteps * kSteps;
  /// Up to this distance, triangles within it differ by at most kMaxApart, wherever B lies.
  static constexpr uint32_t kMostShort = (1u << 23) - 1;
  static constexpr uint32_t kMost = static_cast<uint32_t>(kMaxFarOffset) * kSteps;

  uint32_t short_distance : 24;  ///< kMostShort + 1 for all longer distances
  uint32_t expensive_tests : 8;  ///< tests that only the exact distance decided; 255 for more
  Direction direction;           ///< of the last separation; for a long distance, the distance

  explicit Within(FineLength distance = {0})
      : short_distance((distance.count <= kMostShort ? distance.count : kMostShort + 1) & 0xFFFFFF),
        expensive_tests(0) {
    if (!is_short()) {
      direction.packed = distance.count;
    }
  }
  bool is_short() const { return (short_distance & (kMostShort + 1)) == 0; }
  uint32_t distance() const { return is_short() ? short_distance : direction.packed; }

  bool is_kept(const Transform& transform) const { return KeptGap::is_for(transform, limit()); }
  KeptGap kept(const Transform& transform) const { return {transform, limit()}; }
  TranslatedGap translated(const TranslatedTransform& transform) const {
    return {transform.offset, limit()};
  }

  /// If B was put nearer than it lies, only the answer "no" is valid.
  template <class Mesh>
  Status error_of(const Transform& transform, const Mesh& a, const Mesh& b) const {
    if (distance() > kMost) {
      return Status::distance_out_of_range;
    }
    return !transform.is_beyond() || !may_matter(transform, a.nodes[0].box, b.nodes[0].box)
               ? Status::done
               : Status::distance_out_of_range;
  }

  bool test(const Triangle& a, const Triangle& b, uint32_t, uint32_t) {
    const uint32_t steps = short_distance;
    if (steps > kMostShort ? are_boxes_separate(a, b) : are_separate(a, b, steps)) {
      return false;
    }
    if (expensive_tests != UINT8_MAX) {
      ++expensive_tests;
    }
    return is_within(a, b, {squared_any(), kStepsSquared});
  }

 protected:
  /// For short distances.
  uint64_t squared_steps() const {
    const uint64_t steps = short_distance;
    return steps * steps;
  }
  int64_t squared() const { return static_cast<int64_t>(squared_steps() / kStepsSquared); }

  uint64_t squared_any() const { return uint64_t{distance()} * distance(); }
  GapLimit limit() const { return GapLimit(static_cast<int64_t>(squared_any() / kStepsSquared)); }
  /// For short distances.
  bool are_separate(const Triangle& a, const Triangle& b, uint32_t steps) {
    const uint64_t squared = uint64_t{steps} * steps;
    // 32 bits from here on, to spare the registers of 64.
    const uint32_t limit =
        static_cast<uint32_t>(squared) >> 16 | static_cast<uint32_t>(squared >> 32) << 16;
    return squared_box_gap(a, b) > limit || directions_separate(a, b, limit, direction) ||
           planes_separate(a, b, limit);
  }
  /// For any distance.
  FLASHBVH_NOINLINE bool are_boxes_separate(const Triangle& a, const Triangle& b) const {
    return static_cast<uint64_t>(squared_box_gap(a, b)) > squared_any() / kStepsSquared;
  }
  bool may_matter(const Transform& transform, const PackedBox& a, const PackedBox& b) const {
    return kept(transform)(a, b);
  }
};

}  // namespace flashbvh::detail

#pragma GCC diagnostic pop
