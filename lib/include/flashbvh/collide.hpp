// One question, one call: each runs a query to its end. For slices, and for all else, query.hpp.
//
// Every call has a query on its stack: at most 720 bytes with all that it calls, on Cortex-M3 to
// M55 at -O2. It takes as long as the answer takes; where that is too long, cut a query into runs.
// Errors are those of Query, in the status.
#ifndef FLASHBVH_COLLIDE_HPP
#define FLASHBVH_COLLIDE_HPP

#include <stdint.h>

#include "flashbvh/query.hpp"

namespace flashbvh {

/// The answer to yes or no. After an error `yes` is true: what cannot be decided may collide.
struct [[nodiscard]] Answer {
  Status status;
  bool yes;
};

/// The query that a kind of mesh has by default.
template <class Index>
using DefaultQuery = Query<Ranked<BasicMesh<Index, Layout::post_indexed>>>;

/// The first pair that the query finds, in `found`, which is written only if there is one.
template <class Index>
Answer first_pair(const BasicMesh<Index, Layout::post_indexed>& a,
                  const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose,
                  TrianglePair<Index>& found) {
  DefaultQuery<Index> query(a, b, pose);
  const Status status = query.run(UINT32_MAX, &found, 1).status;
  const bool yes = status == Status::full;
  return {yes ? Status::done : status, status != Status::done};
}

/// Whether any two triangles intersect; ends at the first pair that does.
template <class Index>
Answer intersects(const BasicMesh<Index, Layout::post_indexed>& a,
                  const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose) {
  TrianglePair<Index> found;
  return first_pair(a, b, pose, found);
}

/// Hands each intersecting pair to `visit(pair)`, in the query's order, until it returns false.
/// `done` at the end, `full` if `visit` said no more.
template <class Index, class Visitor>
FLASHBVH_INLINE inline Status for_each_pair(const BasicMesh<Index, Layout::post_indexed>& a,
                                            const BasicMesh<Index, Layout::post_indexed>& b,
                                            const Pose& pose, Visitor&& visit) {
  DefaultQuery<Index> query(a, b, pose);
  return query.run(UINT32_MAX, visit).status;
}

/// How many pairs of triangles intersect: the result's `count`, 0 after an error.
template <class Index>
RunResult count_pairs(const BasicMesh<Index, Layout::post_indexed>& a,
                      const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose) {
  DefaultQuery<Index> query(a, b, pose);
  return query.run(UINT32_MAX, [](const TrianglePair<Index>&) { return true; });
}

/// The first `capacity` pairs that intersect. `done`: these are all; `full`: there may be more.
template <class Index>
RunResult find_pairs(const BasicMesh<Index, Layout::post_indexed>& a,
                     const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose,
                     TrianglePair<Index>* found, uint32_t capacity) {
  DefaultQuery<Index> query(a, b, pose);
  return query.run(UINT32_MAX, found, capacity);
}

}  // namespace flashbvh

#endif
