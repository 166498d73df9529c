// Where a mesh intersects itself: which of its triangles intersect which others, each unordered
// pair once, and which are within a distance of each other.
//
// Triangles that share a vertex, by its index, are no answer: they always touch there. Vertices
// that merely lie in one place are different ones. Everything else is as of a Query (query.hpp):
// exact, in any slices, resumable, the same on every core. Of a pair, `a` is the triangle that lies
// first in the mesh's array.
//
// 128 bytes on a 32-bit core, 136 for the band. Stack of a run on a Cortex-M4 at -O2: 432
// bytes, 632 for the band (proofs/stack).
#ifndef FLASHBVH_SELF_HPP
#define FLASHBVH_SELF_HPP

#include <stdint.h>

#include "flashbvh/clearance.hpp"
#include "flashbvh/collide.hpp"
#include "flashbvh/detail/query/self_predicate.hpp"
#include "flashbvh/detail/walk/self_ranked.hpp"
#include "flashbvh/query.hpp"

namespace flashbvh {

/// `PredicateBase`: detail::Intersection or Within. The mesh outlives the query.
template <class MeshType, class PredicateBase>
class BasicSelfQuery
    : public Query<detail::SelfRanked<MeshType>, detail::SelfPredicate<PredicateBase>> {
  using Predicate = detail::SelfPredicate<PredicateBase>;
  using Base = Query<detail::SelfRanked<MeshType>, Predicate>;

 public:
  /// With `within(distance)` (clearance.hpp) as the predicate of a SelfWithinQuery.
  explicit BasicSelfQuery(const MeshType& mesh, const PredicateBase& predicate = PredicateBase())
      : BasicSelfQuery(mesh, predicate, Pose::translated(0, 0, 0)) {}
  explicit BasicSelfQuery(const MeshType&&, const PredicateBase& = PredicateBase()) = delete;

 private:
  /// A translation is not looked at again.
  BasicSelfQuery(const MeshType& mesh, const PredicateBase& predicate, const Pose& identity)
      : Base(mesh, mesh, identity, {}, Predicate(predicate)) {}
};

using SelfQuery = BasicSelfQuery<Mesh, detail::Intersection>;
using SelfQuery32 = BasicSelfQuery<Mesh32, detail::Intersection>;
using SelfWithinQuery = BasicSelfQuery<Mesh, Within>;
using SelfWithinQuery32 = BasicSelfQuery<Mesh32, Within>;

/// Whether any two triangles of a mesh that share no vertex intersect; ends at the first pair.
template <class Index>
Answer intersects_itself(const BasicMesh<Index, Layout::post_indexed>& mesh) {
  BasicSelfQuery<BasicMesh<Index, Layout::post_indexed>, detail::Intersection> query(mesh);
  TrianglePair<Index> found;
  const Status status = query.run(UINT32_MAX, &found, 1).status;
  return {status == Status::full ? Status::done : status, status != Status::done};
}

// Compiled once, in the library.
extern template class detail::QueryRun<detail::SelfRanked<Mesh>,
                                       detail::SelfPredicate<detail::Intersection>>;
extern template class detail::QueryRun<detail::SelfRanked<Mesh>, detail::SelfPredicate<Within>>;
extern template class detail::QueryRun<detail::SelfRanked<Mesh32>,
                                       detail::SelfPredicate<detail::Intersection>>;
extern template class detail::QueryRun<detail::SelfRanked<Mesh32>, detail::SelfPredicate<Within>>;
extern template class Query<detail::SelfRanked<Mesh>, detail::SelfPredicate<detail::Intersection>>;
extern template class Query<detail::SelfRanked<Mesh32>,
                            detail::SelfPredicate<detail::Intersection>>;
extern template class Query<detail::SelfRanked<Mesh>, detail::SelfPredicate<Within>>;
extern template class Query<detail::SelfRanked<Mesh32>, detail::SelfPredicate<Within>>;

}  // namespace flashbvh

#endif
