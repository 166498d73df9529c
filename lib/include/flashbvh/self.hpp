// Self-intersection of a mesh: its pairs of triangles that intersect, or are within a distance,
// each unordered pair once.
//
// Triangles that share a vertex index are not reported: they always touch there. Vertices at equal
// coordinates with different indices are different. All else is as in a Query (query.hpp): exact,
// in any slices, resumable, equal on every core. In a pair, `a` has the lower slot.
//
// 128 bytes on a 32-bit core, 136 for the band. Stack of a run on a Cortex-M4 at -O2: 432 bytes,
// 632 for the band (proofs/stack).
#pragma once

#include <stdint.h>

#include "flashbvh/clearance.hpp"
#include "flashbvh/collide.hpp"
#include "flashbvh/detail/query/self_predicate.hpp"
#include "flashbvh/detail/walk/self_ranked.hpp"
#include "flashbvh/query.hpp"

namespace flashbvh {

/// `PredicateBase`: detail::Intersection or Within. The mesh must outlive the query.
template <class MeshType, class PredicateBase>
class BasicSelfQuery
    : public Query<detail::SelfRanked<MeshType>, detail::SelfPredicate<PredicateBase>> {
  using Predicate = detail::SelfPredicate<PredicateBase>;
  using Base = Query<detail::SelfRanked<MeshType>, Predicate>;

 public:
  /// A SelfWithinQuery takes `within(distance)` (clearance.hpp) as its predicate.
  FLASHBVH_INLINE_TO_RUN explicit BasicSelfQuery(const MeshType& mesh,
                                                 const PredicateBase& predicate = PredicateBase())
      : BasicSelfQuery(mesh, predicate, Pose::translated(0, 0, 0)) {}
  explicit BasicSelfQuery(const MeshType&&, const PredicateBase& = PredicateBase()) = delete;

 private:
  /// The query does not use `identity` after the constructor.
  FLASHBVH_INLINE_TO_RUN BasicSelfQuery(const MeshType& mesh, const PredicateBase& predicate,
                                        const Pose& identity)
      : Base(mesh, mesh, identity, {}, Predicate(predicate)) {}
};

using SelfQuery = BasicSelfQuery<Mesh, detail::Intersection>;
using SelfWithinQuery = BasicSelfQuery<Mesh, Within>;

/// True if any two triangles of a mesh that share no vertex intersect; ends at the first pair.
template <class Index>
Answer intersects_itself(const BasicMesh<Index, Layout::post_indexed>& mesh) {
  BasicSelfQuery<BasicMesh<Index, Layout::post_indexed>, detail::Intersection> query(mesh);
  TrianglePair<Index> found;
  return detail::answer_of(query.run(UINT32_MAX, &found, 1).status);
}

// Compiled once, in the library.
FLASHBVH_COMPILED_QUERY_RUN(extern, detail::SelfRanked<Mesh>,
                            detail::SelfPredicate<detail::Intersection>);
FLASHBVH_COMPILED_QUERY_RUN(extern, detail::SelfRanked<Mesh>, detail::SelfPredicate<Within>);
extern template class Query<detail::SelfRanked<Mesh>, detail::SelfPredicate<detail::Intersection>>;
extern template class Query<detail::SelfRanked<Mesh>, detail::SelfPredicate<Within>>;

}  // namespace flashbvh
