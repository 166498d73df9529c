// The predicates of distance: which triangles are within d of each other, and which are nearest.
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

/// What a run knows of the nearest pair so far: worked out of the pair when the run begins.
struct NearestSoFar {
  Fraction least = kInfinite;  ///< squared distance
  int64_t limit = INT64_MAX;   ///< the largest squared gap that still matters
  Axis axis = {0, 0, 0, 0};
  Direction direction;
};

/// Which triangles are nearer than all that were tested before: the last answer is the nearest.
///
/// `allowance`, in 2^-16: the nearest that is found may be farther than the nearest by so much of
/// its distance.
template <class Index>
struct Nearest : ProximityPredicate {
  static constexpr uint32_t kBatch = 1;
  static constexpr uint32_t kPairWork = kTrianglePairWork;
  static constexpr uint32_t kDearWork = 0;
  static constexpr bool kKeepsShapes = true;

  uint32_t tested = 0;  ///< pairs of triangles
  union {
    uint32_t beyond = 0;   ///< between runs: by how much at most B was put nearer, in 1/256 cell
    NearestSoFar* so_far;  ///< the run's, while it lasts
  };
  Index nearest_a = 0;  ///< the positions of the nearest so far
  Index nearest_b = 0;
  uint16_t allowance = 0;
  bool has_nearest = false;  ///< whether there is a nearest
  bool intersect = false;

  bool is_kept(const Transform& transform) const {
    return KeptGap::is_for(transform, GapLimit(so_far->limit));
  }
  KeptGap kept(const Transform& transform) const { return {transform, GapLimit(so_far->limit)}; }
  TranslatedGap translated(const TranslatedTransform& transform) const {
    return {transform.offset, GapLimit(so_far->limit)};
  }

  template <class Mesh>
  Status error_of(const Transform&, const Mesh&, const Mesh&) const {
    return Status::done;
  }

  bool test(const Triangle& a, const Triangle& b, uint32_t i, uint32_t j) {
    const int64_t limit = so_far->limit;
    ++tested;
    if (so_far->axis.separates(a, b) || squared_box_gap(a, b) > limit ||
        (limit < kMostLimit &&
         (directions_separate(a, b, limit, so_far->direction) || planes_separate(a, b, limit)))) {
      return false;
    }
    Features features;
    if (!is_nearer(a, b, so_far->least, features)) {
      return false;
    }
    nearest_a = static_cast<Index>(i);
    nearest_b = static_cast<Index>(j);
    has_nearest = true;
    intersect = features.kind == FeatureKind::intersection;
    so_far->limit = largest_below(so_far->least, allowance);
    so_far->axis = intersect ? Axis{0, 0, 0, 0} : axis_of(a, b, features);
    return true;
  }
};

}  // namespace flashbvh::detail

#endif
