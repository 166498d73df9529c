// One call for each query: each function runs a query to its end. query.hpp has slices and more.
//
// Every call has a query on its stack: at most 720 bytes with all functions that it calls, on
// Cortex-M3 to M55 at -O2. A call ends when the answer is complete; if that takes too long, cut a
// query into runs. Errors are those of Query, in the status.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/query/first_query.hpp"
#include "flashbvh/query.hpp"

namespace flashbvh {

/// A yes-or-no answer. After an error `yes` is true: an undecided pair may collide.
struct [[nodiscard]] Answer {
  Status status;
  bool yes;
};

/// Two triangles by their slots in the meshes' arrays: a hint for later queries. Opaque, storable.
template <class Index>
struct Witness {
  Index a = static_cast<Index>(-1);
  Index b = static_cast<Index>(-1);

  /// True if it holds no pair, as by default.
  bool is_none() const { return a == static_cast<Index>(-1) && b == static_cast<Index>(-1); }
};

namespace detail {

/// True if a hint is a pair of these meshes' triangles.
template <class Mesh>
bool is_pair(const Witness<typename Mesh::Index>& hint, const Mesh& a, const Mesh& b) {
  return hint.a < a.triangle_count && hint.b < b.triangle_count;
}

/// Returns the answer of a query that ends at the first pair, with `full` if there is one.
inline Answer answer_of(Status status) {
  return {status == Status::full ? Status::done : status, status != Status::done};
}

}  // namespace detail

/// The default query for meshes with a given index type.
template <class Index>
using DefaultQuery = Query<Ranked<BasicMesh<Index, Layout::post_indexed>>>;

/// Searches for one pair of triangles that intersect, and writes it to `found` only if there is
/// one. Other queries may find another pair first.
template <class Index>
Answer first_pair(const BasicMesh<Index, Layout::post_indexed>& a,
                  const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose,
                  TrianglePair<Index>& found) {
  detail::FirstQuery<Index> query(a, b, pose);
  return detail::answer_of(
      query.find(true, [&](const TrianglePair<Index>& pair) { found = pair; }));
}

/// True if any two triangles intersect. Searches first where the meshes overlap most, and ends at
/// the first pair.
template <class Index>
Answer intersects(const BasicMesh<Index, Layout::post_indexed>& a,
                  const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose) {
  detail::FirstQuery<Index> query(a, b, pose);
  return detail::answer_of(query.find(true, [](const TrianglePair<Index>&) {}));
}

/// Repeats the test along a motion. `hint`: the pair that intersected last, which is tested first;
/// none at first. After a no or an error it is none again; the search then takes the order that
/// finds a no soonest. The hint never changes the answer. `hint_invalid`: it is no pair of these
/// meshes' triangles; the hint does not change.
///
/// About 1,300 instructions on a Cortex-M4 at -O2 if the hint's triangles intersect
/// (lib/docs/figures.md).
template <class Index>
Answer intersects(const BasicMesh<Index, Layout::post_indexed>& a,
                  const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose,
                  Witness<Index>& hint) {
  using Order = detail::NearFirst<BasicMesh<Index, Layout::post_indexed>>;
  detail::FirstQuery<Index> query(a, b, pose,
                                  hint.is_none() ? Order::as_ranked() : typename Order::Cursor());
  if (!hint.is_none() && !detail::is_pair(hint, a, b)) {
    return {query.status() == Status::suspended ? Status::hint_invalid : query.status(), true};
  }
  if (!hint.is_none() && query.holds(hint.a, hint.b)) {
    return {Status::done, true};
  }
  const Answer answer =
      detail::answer_of(query.find(!hint.is_none(), [](const TrianglePair<Index>&) {}));
  hint = answer.yes && answer.status == Status::done ? query.template found_slots<Witness<Index>>()
                                                     : Witness<Index>();
  return answer;
}

/// Passes each intersecting pair to `visit(pair)`, in the query's order, until it returns false.
/// `done` at the end, `full` if `visit` returned false.
template <class Index, class Visitor>
FLASHBVH_INLINE inline Status for_each_pair(const BasicMesh<Index, Layout::post_indexed>& a,
                                            const BasicMesh<Index, Layout::post_indexed>& b,
                                            const Pose& pose, Visitor&& visit) {
  DefaultQuery<Index> query(a, b, pose);
  return query.run(UINT32_MAX, visit).status;
}

/// Returns the number of intersecting pairs of triangles in `count`, 0 after an error.
template <class Index>
RunResult count_pairs(const BasicMesh<Index, Layout::post_indexed>& a,
                      const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose) {
  DefaultQuery<Index> query(a, b, pose);
  return query.run(UINT32_MAX, [](const TrianglePair<Index>&) { return true; });
}

/// Writes the first `capacity` intersecting pairs. `done`: these are all; `full`: maybe not.
template <class Index>
RunResult find_pairs(const BasicMesh<Index, Layout::post_indexed>& a,
                     const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose,
                     TrianglePair<Index>* found, uint32_t capacity) {
  DefaultQuery<Index> query(a, b, pose);
  return query.run(UINT32_MAX, found, capacity);
}

// Compiled once, in the library.
FLASHBVH_COMPILED_QUERY_RUN(extern, detail::NearFirst<Mesh>, detail::Intersection);
FLASHBVH_COMPILED_QUERY_RUN(extern, detail::NearFirst<Mesh32>, detail::Intersection);
extern template class detail::FirstQuery<uint16_t>;
extern template class detail::FirstQuery<uint32_t>;

}  // namespace flashbvh
