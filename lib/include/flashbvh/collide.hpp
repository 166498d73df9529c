// One question, one call: each runs a query to its end. For slices, and for all else, query.hpp.
//
// Every call has a query on its stack: at most 720 bytes with all that it calls, on Cortex-M3 to
// M55 at -O2. It takes as long as the answer takes; where that is too long, cut a query into runs.
// Errors are those of Query, in the status.
#ifndef FLASHBVH_COLLIDE_HPP
#define FLASHBVH_COLLIDE_HPP

#include <stdint.h>

#include "flashbvh/detail/predicates/triangle.hpp"
#include "flashbvh/detail/walk/near_first.hpp"
#include "flashbvh/query.hpp"

namespace flashbvh {

/// The answer to yes or no. After an error `yes` is true: what cannot be decided may collide.
struct [[nodiscard]] Answer {
  Status status;
  bool yes;
};

/// Two triangles by their positions in the meshes' arrays: what a later query begins with. Opaque;
/// may be stored.
template <class Index>
struct Witness {
  Index a = static_cast<Index>(-1);
  Index b = static_cast<Index>(-1);

  /// By default it is none.
  bool is_none() const { return a == static_cast<Index>(-1) && b == static_cast<Index>(-1); }
};

namespace detail {

/// Whether a hint is a pair of these meshes' triangles.
template <class Mesh>
bool is_pair(const Witness<typename Mesh::Index>& hint, const Mesh& a, const Mesh& b) {
  return hint.a < a.triangle_count && hint.b < b.triangle_count;
}

/// Of a query that ends at the first pair: `full` where there is one.
inline Answer answer_of(Status status) {
  return {status == Status::full ? Status::done : status, status != Status::done};
}

}  // namespace detail

/// The query that a kind of mesh has by default.
template <class Index>
using DefaultQuery = Query<Ranked<BasicMesh<Index, Layout::post_indexed>>>;

namespace detail {

/// A search for one pair, whichever is found first.
template <class Index>
class FirstQuery : public Query<NearFirst<BasicMesh<Index, Layout::post_indexed>>> {
  using Base = Query<NearFirst<BasicMesh<Index, Layout::post_indexed>>>;

 public:
  using Base::Base;

  /// `take(pair)` is called only if there is one.
  template <class Take>
  FLASHBVH_INLINE Answer find(const Take& take) {
    uint32_t work = UINT32_MAX;
    const auto sink = [&take](const TrianglePair<Index>& pair) {
      take(pair);
      return false;
    };
    return answer_of(this->run_with(work, sink, [] { return UINT32_MAX; }));
  }
  /// Whether the triangles of a hint that is none or a pair intersect.
  FLASHBVH_NOINLINE bool holds(const Witness<Index>& hint) const {
    if (hint.is_none() || this->error() != Status::done || this->transform().roots_disjoint()) {
      return false;
    }
    Triangle a;
    Triangle b;
    translate_triangle(this->mesh_a(), hint.a, kNoOffset, a);
    transform_triangle(this->mesh_b(), hint.b, this->transform(), b);
    return triangles_intersect(a, b);
  }
};

}  // namespace detail

/// A pair of triangles that intersect, the first that a search finds, in `found`, which is written
/// only if there is one. Where all pairs are wanted, or a query in slices, others come first.
template <class Index>
Answer first_pair(const BasicMesh<Index, Layout::post_indexed>& a,
                  const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose,
                  TrianglePair<Index>& found) {
  detail::FirstQuery<Index> query(a, b, pose);
  return query.find([&found](const TrianglePair<Index>& pair) { found = pair; });
}

/// Whether any two triangles intersect; ends at the first pair that does, which it looks for where
/// the meshes overlap most.
template <class Index>
Answer intersects(const BasicMesh<Index, Layout::post_indexed>& a,
                  const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose) {
  detail::FirstQuery<Index> query(a, b, pose);
  return query.find([](const TrianglePair<Index>&) {});
}

/// The same along a motion: `hint` is the pair that intersected last, and is tested before all
/// else. At first it is none, and after a no or an error it is none again; then a no is the
/// likelier answer, and the search takes the order that finds it soonest. It never changes the
/// answer. `hint_invalid`: it is no pair of these meshes' triangles, and stays as it is.
///
/// About 1,300 instructions on a Cortex-M4 at -O2 where the hint holds (lib/docs/figures.md).
template <class Index>
Answer intersects(const BasicMesh<Index, Layout::post_indexed>& a,
                  const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose,
                  Witness<Index>& hint) {
  using Order = detail::NearFirst<BasicMesh<Index, Layout::post_indexed>>;
  detail::FirstQuery<Index> query(a, b, pose,
                                  hint.is_none() ? Order::as_ranked() : typename Order::Cursor());
  if (!hint.is_none() && !detail::is_pair(hint, a, b)) {
    return {Status::hint_invalid, true};
  }
  if (query.holds(hint)) {
    return {Status::done, true};
  }
  const Answer answer = query.find([](const TrianglePair<Index>&) {});
  hint = answer.yes && answer.status == Status::done ? query.template last_slots<Witness<Index>>()
                                                     : Witness<Index>();
  return answer;
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

// Compiled once, in the library.
extern template class detail::QueryRun<detail::NearFirst<Mesh>, detail::Intersection>;
extern template class detail::QueryRun<detail::NearFirst<Mesh32>, detail::Intersection>;

}  // namespace flashbvh

#endif
