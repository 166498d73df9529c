// The predicate of bands: which triangles are within a distance of each other.
#ifndef FLASHBVH_DETAIL_QUERY_PROXIMITY_HPP
#define FLASHBVH_DETAIL_QUERY_PROXIMITY_HPP

#include <stdint.h>

#include "flashbvh/detail/bounds/gap.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "flashbvh/detail/walk/proximity_planes.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh::detail {

/// What predicates of distance share: box tests of gaps, widened by nothing.
struct ProximityPredicate {
  static constexpr int64_t kMostLimit = int64_t{1} << 35;
  using KeepsBound = void;
  static constexpr bool kAlwaysKeepsBound = false;
  static constexpr bool kIntersects = false;
  template <class Mesh>
  using Shapes = ProximityPlanes<Mesh>;
  static constexpr bool kDisjointRootsEnd = false;
};

/// Which triangles have points within a distance: closed, so equal is within.
struct Within : ProximityPredicate {
  static constexpr uint32_t kBatch = 4;
  static constexpr uint32_t kPairWork = kNearPairWork;
  static constexpr uint32_t kDearWork = kDearPairWork;
  static constexpr bool kKeepsShapes = false;
  /// Steps of a distance in a cell: 1/256, as everywhere.
  static constexpr uint32_t kSteps = 256;
  static constexpr uint32_t kStepsSquared = kSteps * kSteps;
  static constexpr uint32_t kMost = 32'767 * kSteps;

  uint32_t distance : 24;   ///< one beyond kMost for all that are
  uint32_t dear_tests : 8;  ///< that nothing but the distance could decide; 255 for more
  Direction direction;      ///< that separated two triangles last

  Within() : distance(0), dear_tests(0) {}

  bool is_kept(const Transform& transform) const { return KeptGap::is_for(transform, limit()); }
  KeptGap kept(const Transform& transform) const { return {transform, limit()}; }
  TranslatedGap translated(const TranslatedTransform& transform) const {
    return {transform.offset, limit()};
  }

  /// Of a B that was put nearer than it lies only "no" is an answer.
  template <class Mesh>
  Status error_of(const Transform& transform, const Mesh& a, const Mesh& b) const {
    if (distance > kMost) {
      return Status::distance_out_of_range;
    }
    return transform.is_in_range() || !may_matter(transform, a.nodes[0].box, b.nodes[0].box)
               ? Status::done
               : Status::distance_out_of_range;
  }

  bool test(const Triangle& a, const Triangle& b, uint32_t, uint32_t) {
    if (squared_box_gap(a, b) > squared() || directions_separate(a, b, squared(), direction) ||
        planes_separate(a, b, squared())) {
      return false;
    }
    if (dear_tests != UINT8_MAX) {
      ++dear_tests;
    }
    return is_within(a, b, {squared_steps(), kStepsSquared});
  }

 protected:
  uint64_t squared_steps() const {
    const uint64_t steps = distance;
    return steps * steps;
  }
  int64_t squared() const { return static_cast<int64_t>(squared_steps() / kStepsSquared); }

 private:
  GapLimit limit() const { return GapLimit(squared()); }
  bool may_matter(const Transform& transform, const PackedBox& a, const PackedBox& b) const {
    return kept(transform)(a, b);
  }
};

}  // namespace flashbvh::detail

#endif
