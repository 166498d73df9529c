// The predicate of PairQuery: triangles that intersect.
//
// A predicate decides a walk's pairs for a query. It is a small class with
//     kIntersects             true if only triangles that intersect are an answer: then the exact
//                             test is known, and any test that finds them disjoint may reject them
//     Shapes<Mesh>            the leaf planes (leaf_planes.hpp), or NoShapes
//     kBatch                  the most pairs of leaves in a batch: one if an answer changes the box
//                             test
//     kPairWork               the work of testing two triangles (work.hpp)
//     kExpensiveWork          the extra work for each of `expensive_tests`, which it counts, or 0
//     kKeepsShapes            true if the current leaf's planes stay from one walk to the next; if
//                             not, they take no stack while triangles are tested
//     kDisjointRootsEnd       true if disjoint root boxes end the query
//     translated(transform)   returns a walk's box test under a translation
//     rotated(transform)      returns one under a rotation; it may have a state for the run
//     test(a, b, i, j)        unless kIntersects: true if A's i-th and B's j-th triangle, in A's
//                             frame, are an answer; may change the predicate
//     KeepsBound              a type, void, if a translated B may have a stateful box test, too:
//                             then is_kept(transform) decides, unless kAlwaysKeepsBound, and
//                             kept(transform) returns it instead of rotated()
//     StaysNear               a type, void, if the limit is too short for a far B, which is then
//                             put nearer
//     error_of(transform, a, b)   unless kDisjointRootsEnd: returns the predicate's error
// The predicate widens its box tests so that they reject no answer.
#pragma once

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/box_rotated.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/walk/leaf_planes.hpp"
#include "flashbvh/detail/walk/walk.hpp"
#include "flashbvh/detail/walk/work.hpp"

namespace flashbvh::detail {

/// The stateful box test of a predicate and a transform.
template <class Predicate, class = void>
struct StatefulBoxTest {
  static constexpr bool kAlways = false;
  /// True if a walk uses it.
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

/// True if a predicate of distance supports a far B.
template <class Predicate, class = void>
struct SeesFar {
  static constexpr bool kValue = !Predicate::kDisjointRootsEnd;
};
template <class Predicate>
struct SeesFar<Predicate, typename Predicate::StaysNear> {
  static constexpr bool kValue = false;
};

/// Leaf planes that stay from one walk to the next; or none, and each walk makes its own.
template <class ShapesType, bool kKept>
struct KeptShapes {
  using Shapes = ShapesType;
  using Current = Shapes&;
  template <class... Parts>
  FLASHBVH_INLINE static Shapes& current(Shapes& kept, const Parts&...) {
    return kept;
  }
};
template <class ShapesType>
struct KeptShapes<ShapesType, false> {
  struct Shapes {
    template <class... Parts>
    explicit Shapes(const Parts&...) {}
  };
  using Current = ShapesType;
  template <class... Parts>
  FLASHBVH_INLINE static ShapesType current(Shapes&, const Parts&... parts) {
    return ShapesType(parts...);
  }
};

struct Intersection {
  static constexpr bool kIntersects = true;
  template <class Mesh>
  using Shapes = LeafPlanes<Mesh>;
  static constexpr uint32_t kBatch = 8;
  static constexpr uint32_t kPairWork = kTrianglePairWork;
  static constexpr uint32_t kExpensiveWork = 0;
  static constexpr bool kKeepsShapes = true;
  static constexpr bool kDisjointRootsEnd = true;

  const TranslatedBoxTest& translated(const TranslatedTransform& transform) const {
    return transform.bound;
  }
  RotatedBoxTest rotated(const RotatedTransform& transform) const {
    return RotatedBoxTest(transform);
  }
};

/// Intersection without leaf planes, as in the paper: the reference that leaf planes are measured
/// against.
struct BoxIntersection : Intersection {
  template <class Mesh>
  using Shapes = NoShapes<Mesh>;
};

}  // namespace flashbvh::detail
