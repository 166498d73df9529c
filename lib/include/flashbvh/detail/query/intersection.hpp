// The predicate of PairQuery: which triangles intersect.
//
// A predicate is the test that a query makes of a walk's pairs. It is a small class with
//     kIntersects             whether only triangles that intersect are an answer: then any test
//                             that finds them disjoint may reject pairs, and the exact test is
//                             known
//     Shapes<Mesh>            how leaves are taken as shapes (leaf_planes.hpp), or NoShapes
//     kBatch                  how many pairs of leaves may be found before they are tested: one if
//                             an answer changes the bound
//     kPairWork               what two triangles' test is in work (work.hpp)
//     kDearWork               what comes on top for each of `dear_tests`, which it counts, or 0
//     kKeepsShapes            whether the current leaf stays a shape from one walk to the next; if
//                             not, it makes room on the stack while triangles are tested
//     kDisjointRootsEnd       whether nothing matters where the root boxes are disjoint
//     translated(transform)   a bound for the walk under a translation
//     rotated(transform)      one under a rotation, which may have a state: a run's own
//     test(a, b, i, j)        unless kIntersects: whether two triangles in A's frame are an answer,
//                             A's i-th and B's j-th; may change the predicate
//     KeepsBound              a type, void, if not only a rotated B has a bound with a state: then
//                             is_kept(transform) decides, unless kAlwaysKeepsBound, and
//                             kept(transform) makes it, not rotated()
//     StaysNear               a type, void, if its limit is too short for a B that lies far off,
//     which
//                             is then put nearer
//     error_of(transform, a, b)   unless kDisjointRootsEnd: what is wrong with the predicate
// Box tests are the predicate's to widen; a test may only say yes where they do not say no.
#ifndef FLASHBVH_DETAIL_QUERY_INTERSECTION_HPP
#define FLASHBVH_DETAIL_QUERY_INTERSECTION_HPP

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/box_rotated.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/walk/leaf_planes.hpp"
#include "flashbvh/detail/walk/walk.hpp"
#include "flashbvh/detail/walk/work.hpp"

namespace flashbvh::detail {

/// The box test with a state, of a predicate and where B lies.
template <class Predicate, class = void>
struct StatefulBoxTest {
  static constexpr bool kAlways = false;
  /// Whether a walk takes it.
  FLASHBVH_INLINE static bool is_for(const Predicate& /*predicate*/, const Transform& transform) {
    return transform.is_rotated();
  }
  FLASHBVH_INLINE static auto of(const Predicate& predicate, const Transform& transform) {
    return predicate.rotated(transform.rotated());
  }
};
template <class Predicate>
struct StatefulBoxTest<Predicate, typename Predicate::KeepsBound> {
  static constexpr bool kAlways = Predicate::kAlwaysKeepsBound;
  FLASHBVH_INLINE static bool is_for(const Predicate& predicate, const Transform& transform) {
    return predicate.is_kept(transform);
  }
  FLASHBVH_INLINE static auto of(const Predicate& predicate, const Transform& transform) {
    return predicate.kept(transform);
  }
};

/// Whether a predicate of distance sees a far B.
template <class Predicate, class = void>
struct SeesFar {
  static constexpr bool kValue = !Predicate::kDisjointRootsEnd;
};
template <class Predicate>
struct SeesFar<Predicate, typename Predicate::StaysNear> {
  static constexpr bool kValue = false;
};

/// Shapes that stay from one walk to the next; or none, and each walk makes its own.
template <class ShapesType, bool kKept>
struct KeptShapes {
  using Shapes = ShapesType;
  using AtHand = Shapes&;
  template <class... Parts>
  FLASHBVH_INLINE static Shapes& at_hand(Shapes& kept, const Parts&...) {
    return kept;
  }
};
template <class ShapesType>
struct KeptShapes<ShapesType, false> {
  struct Shapes {
    template <class... Parts>
    explicit Shapes(const Parts&...) {}
  };
  using AtHand = ShapesType;
  template <class... Parts>
  FLASHBVH_INLINE static ShapesType at_hand(Shapes&, const Parts&... parts) {
    return ShapesType(parts...);
  }
};

struct Intersection {
  static constexpr bool kIntersects = true;
  template <class Mesh>
  using Shapes = LeafPlanes<Mesh>;
  static constexpr uint32_t kBatch = 8;
  static constexpr uint32_t kPairWork = kTrianglePairWork;
  static constexpr uint32_t kDearWork = 0;
  static constexpr bool kKeepsShapes = true;
  static constexpr bool kDisjointRootsEnd = true;

  const TranslatedBoxTest& translated(const TranslatedTransform& transform) const {
    return transform.bound;
  }
  RotatedBoxTest rotated(const RotatedTransform& transform) const {
    return RotatedBoxTest(transform);
  }
};

/// The same with boxes alone: the paper's, and what leaves as shapes are measured against.
struct BoxIntersection : Intersection {
  template <class Mesh>
  using Shapes = NoShapes<Mesh>;
};

}  // namespace flashbvh::detail

#endif
