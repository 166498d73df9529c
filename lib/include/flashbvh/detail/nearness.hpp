// The questions about distance: which triangles are within d of each other, and which are nearest.
#ifndef FLASHBVH_DETAIL_NEARNESS_HPP
#define FLASHBVH_DETAIL_NEARNESS_HPP

#include <stdint.h>

#include "flashbvh/detail/gap.hpp"
#include "flashbvh/detail/near_shape.hpp"
#include "flashbvh/detail/transform.hpp"
#include "flashbvh/detail/triangle_distance.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh::detail {

/// What questions about distance have in common: bounds of gaps, widened to nothing.
struct Nearness {
  static constexpr int64_t kMostLimit = int64_t{1} << 35;
  static constexpr bool kIntersects = false;
  template <class Mesh>
  using Shapes = NearShapes<Mesh>;
  static constexpr bool kDisjointRootsEnd = false;
};

/// Which triangles have points within a distance: closed, so equal is within.
struct Within : Nearness {
  static constexpr bool kBatches = true;
  /// Steps of a distance in a cell: 1/256, as everywhere.
  static constexpr uint32_t kSteps = 256;
  static constexpr uint32_t kMost = 32'767 * kSteps;

  uint32_t distance = 0;

  TranslatedGap translated(const TranslatedTransform& transform) const {
    return {transform.offset, limit()};
  }
  RotatedGap rotated(const RotatedTransform& transform) const { return {transform, limit()}; }

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

  bool test(const Triangle& a, const Triangle& b, uint32_t, uint32_t) const {
    return squared_box_gap(a, b) <= squared() && !directions_separate(a, b, squared()) &&
           !planes_separate(a, b, squared()) &&
           is_within(a, b, {{0, uint64_t{distance} * distance}, {0, kSteps * kSteps}});
  }

 private:
  int64_t squared() const {
    return static_cast<int64_t>(uint64_t{distance} * distance / (kSteps * kSteps));
  }
  GapLimit limit() const { return GapLimit(squared()); }
  bool may_matter(const Transform& transform, const PackedBox& a, const PackedBox& b) const {
    return transform.is_rotated() ? rotated(transform.rotated())(a, b)
                                  : translated(transform.translated())(a, b);
  }
};

/// Which triangles are nearer than all that were tested before: the last answer is the nearest.
///
/// `allowance`, in 2^-16: pairs that are nearer by less than so much of the distance may be passed
/// over.
template <class Index>
struct Nearest : Nearness {
  static constexpr bool kBatches = false;
  Fraction least = kInfinite;  ///< squared distance: of the nearest so far
  int64_t limit = INT64_MAX;   ///< the largest squared gap that still matters
  uint16_t allowance = 0;
  Index nearest_a = 0;  ///< the positions of the nearest so far
  Index nearest_b = 0;

  TranslatedGap translated(const TranslatedTransform& transform) const {
    return {transform.offset, gap_limit()};
  }
  RotatedGap rotated(const RotatedTransform& transform) const { return {transform, gap_limit()}; }

  template <class Mesh>
  Status error_of(const Transform&, const Mesh&, const Mesh&) const {
    return Status::done;
  }

  bool test(const Triangle& of_a, const Triangle& of_b, uint32_t i, uint32_t j) {
    Features features;
    if (squared_box_gap(of_a, of_b) > limit ||
        (limit < kMostLimit && (directions_separate(of_a, of_b, limit) ||
                                planes_separate(of_a, of_b, limit)))) {
      return false;
    }
    if (!is_nearer(of_a, of_b, least, features)) {
      return false;
    }
    nearest_a = static_cast<Index>(i);
    nearest_b = static_cast<Index>(j);
    limit = largest_below(least, allowance);
    return true;
  }

 private:
  GapLimit gap_limit() const { return GapLimit(limit); }
};

}  // namespace flashbvh::detail

#endif
