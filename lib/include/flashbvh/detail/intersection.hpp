// The question of PairQuery: which triangles intersect.
//
// A question is what a query asks of a walk's pairs. It is a small class with
//     kLeafShapes             whether leaves may be taken as shapes (leaf_shape.hpp)
//     kDisjointRootsEnd       whether nothing matters where the root boxes are disjoint
//     translated(transform)   a bound for the walk under a translation
//     rotated(transform)      one under a rotation, which may have a state: a run's own
//     test(a, b, narrow)      whether two triangles in A's frame are an answer; `narrow`: none of
//                             their edges is longer than 2^15 - 1 cells along an axis
// Bounds are the question's to widen; a test may only say yes where they do not say no.
#ifndef FLASHBVH_DETAIL_INTERSECTION_HPP
#define FLASHBVH_DETAIL_INTERSECTION_HPP

#include "flashbvh/detail/box_rotated.hpp"
#include "flashbvh/detail/transform.hpp"
#include "flashbvh/detail/triangle.hpp"

namespace flashbvh::detail {

struct Intersection {
  static constexpr bool kLeafShapes = true;
  static constexpr bool kDisjointRootsEnd = true;

  const TranslatedBound& translated(const TranslatedTransform& transform) const {
    return transform.bound;
  }
  RotatedBound rotated(const RotatedTransform& transform) const { return RotatedBound(transform); }
  bool test(const Triangle& a, const Triangle& b, bool narrow) const {
    return narrow ? near_triangles_intersect(a, b) : triangles_intersect(a, b);
  }
};

/// The same with boxes alone: the paper's, and what leaves as shapes are measured against.
struct BoxIntersection : Intersection {
  static constexpr bool kLeafShapes = false;
};

}  // namespace flashbvh::detail

#endif
