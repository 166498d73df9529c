// The question of PairQuery: which triangles intersect.
//
// A question is what a query asks of a walk's pairs. It is a small class with
//     kIntersects             whether only triangles that intersect are an answer: then whatever
//                             tells them disjoint may reject pairs, and the exact test is known
//     Shapes<Mesh>            how leaves are taken as shapes (leaf_shape.hpp), or NoShapes
//     kBatches                whether pairs of leaves may be found before others are tested: not if
//                             an answer changes the bound
//     kDisjointRootsEnd       whether nothing matters where the root boxes are disjoint
//     translated(transform)   a bound for the walk under a translation
//     rotated(transform)      one under a rotation, which may have a state: a run's own
//     test(a, b, i, j)        unless kIntersects: whether two triangles in A's frame are an answer,
//                             A's i-th and B's j-th; may change what the question asks
//     error_of(transform, a, b)   unless kDisjointRootsEnd: what is wrong with the question
// Bounds are the question's to widen; a test may only say yes where they do not say no.
#ifndef FLASHBVH_DETAIL_INTERSECTION_HPP
#define FLASHBVH_DETAIL_INTERSECTION_HPP

#include "flashbvh/detail/box_rotated.hpp"
#include "flashbvh/detail/leaf_shape.hpp"
#include "flashbvh/detail/transform.hpp"

namespace flashbvh::detail {

struct Intersection {
  static constexpr bool kIntersects = true;
  template <class Mesh>
  using Shapes = LeafShapes<Mesh>;
  static constexpr bool kBatches = true;
  static constexpr bool kDisjointRootsEnd = true;

  const TranslatedBound& translated(const TranslatedTransform& transform) const {
    return transform.bound;
  }
  RotatedBound rotated(const RotatedTransform& transform) const { return RotatedBound(transform); }
};

/// The same with boxes alone: the paper's, and what leaves as shapes are measured against.
struct BoxIntersection : Intersection {
  template <class Mesh>
  using Shapes = NoShapes<Mesh>;
};

}  // namespace flashbvh::detail

#endif
