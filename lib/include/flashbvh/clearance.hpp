// Distance of two meshes: the nearest points, and whether the distance exceeds a limit.
//
// Exact on the lattice: the distance is that of the two transformed meshes, an exact fraction of
// square cells, rounded down and up to 1/256 cell. It is a distance of surfaces, not of solids: a
// mesh inside another one is as far from it as from its wall. Meshes that intersect have distance 0
// and no depth. The smallest movement that separates two meshes is no local property of a contact;
// two interlocked combs have none. To push bodies apart, use a band: all pairs within d
// (WithinQuery), each with its distance.
//
// Stack on Cortex-M3 to M55 at -O2, in bytes: a run 880, a result 944, distance() 1,120,
// closer_than() 880 (proofs/stack). Work budgets cut these queries like any other. But the time of
// a unit of work is proven only for PairQuery (time_bound.hpp): two triangles take more here.
//
// Distances are in cells and 1/256 cell; float.hpp and units.hpp convert them to lengths, and
// lengths to a FineLength.
#pragma once

#include <stdint.h>

#include "flashbvh/collide.hpp"
#include "flashbvh/detail/query/nearest.hpp"
#include "flashbvh/detail/query/proximity.hpp"
#include "flashbvh/query.hpp"
#include "flashbvh/triangle.hpp"

namespace flashbvh {

/// The largest distance of a query, in 1/256 cell: 2^20 cells.
constexpr uint32_t kMaxDistance = detail::Within::kMost;

/// Finds every pair of triangles within a distance, in the order and the slices of a PairQuery. It
/// is a Query (query.hpp) with the predicate `within(distance)`.
using Within = detail::Within;
using WithinQuery = Query<Ranked<Mesh>, Within>;

/// Returns the predicate of a WithinQuery. `distance`: at most kMaxDistance; a query beyond it ends
/// with `distance_out_of_range`.
inline Within within(FineLength distance) {
  return Within(distance);
}

/// True if any points of the two meshes are at most `distance` apart; ends at the first such pair
/// of triangles. `distance_out_of_range`, and `yes`: the distance is more than kMaxDistance, or
/// undecidable because B's lattice is 2^20 cells or more along an axis from A's.
template <class Index>
Answer closer_than(const BasicMesh<Index, Layout::post_indexed>& a,
                   const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose,
                   FineLength distance) {
  Query<Ranked<BasicMesh<Index, Layout::post_indexed>>, Within> query(a, b, pose, {},
                                                                      within(distance));
  TrianglePair<Index> found;
  return detail::answer_of(query.run(UINT32_MAX, &found, 1).status);
}

/// The distance of two meshes, as far as it is known.
template <class Index>
struct [[nodiscard]] Clearance {
  /// `done`; `suspended`: work is left; or an error, and no other field is valid.
  Status status;
  /// False if B's lattice is 2^20 cells or more along an axis from A's. Then only `lower` and
  /// `upper` are valid.
  bool in_range;
  /// Lower bound of the distance in 1/256 cell, rounded down; 0 while suspended.
  uint32_t lower;
  /// Upper bound of the distance, rounded up; in range, the distance of `triangles`. UINT32_MAX if
  /// none is known yet, or if the bound may be so large.
  uint32_t upper;
  TrianglePair<Index> triangles;  ///< by their ids
  Witness<Index> witness;         ///< these triangles as a hint for the next query
  FinePoint point_a;              ///< the nearest points of the triangles
  FinePoint point_b;
  UnitVector direction;  ///< from point_a to point_b
};

/// Optional arguments of a distance query.
template <class Index>
struct ClearanceOptions {
  Witness<Index> hint = {};  ///< a pair that may be near: the previous pose's nearest pair
  /// Relative tolerance in 2^-16. The reported distance may exceed the true one, and `lower`, by
  /// this fraction of the true one, apart from rounding.
  uint16_t tolerance = 0;
};

/// The distance of two meshes, in slices. With the last nearest pair as `hint`, the query visits
/// hardly more than the boxes nearer than the answer. Without a hint, it first descends both trees
/// to where they seem nearest, and walks once for pairs of a third of that distance. It drops a
/// hint whose triangles are about 70 % as far apart as the centres of the meshes, or farther.
/// Instructions on each core: lib/docs/figures.md, Distances. The distance never depends on the
/// hint; if several pairs are nearest, the reported one may.
template <class MeshType>
class BasicClearanceQuery
    : protected Query<Ranked<MeshType>, detail::Nearest<typename MeshType::Index>> {
  using Predicate = detail::Nearest<typename MeshType::Index>;
  using Base = Query<Ranked<MeshType>, Predicate>;

 public:
  using Mesh = MeshType;
  using Index = typename Mesh::Index;
  using Hint = Witness<Index>;
  using Options = ClearanceOptions<Index>;

  /// `hint_invalid`: the hint is no pair of these meshes' triangles.
  BasicClearanceQuery(const Mesh& a, const Mesh& b, const Pose& pose,
                      const Options& options = Options())
      : Base(a, b, pose, {}, predicate(options.tolerance)) {
    begin_at(pose, options.hint);
  }
  /// Uses default options except the hint.
  BasicClearanceQuery(const Mesh& a, const Mesh& b, const Pose& pose, const Hint& hint)
      : Base(a, b, pose, {}, predicate(0)) {
    begin_at(pose, hint);
  }
  /// Rejects temporary meshes and poses. `With`: Options or Hint; Options for braces.
  template <class With = Options>
  BasicClearanceQuery(const Mesh&&, const Mesh&, const Pose&, const With& = With()) = delete;
  template <class With = Options>
  BasicClearanceQuery(const Mesh&, const Mesh&&, const Pose&, const With& = With()) = delete;
  template <class With = Options>
  BasicClearanceQuery(const Mesh&, const Mesh&, const Pose&&, const With& = With()) = delete;

  /// `suspended` while there is work left.
  Status status() const {
    return this->error() == Status::done && this->intersect ? Status::done : Base::status();
  }
  using Base::stats;
  /// Returns the number of tested pairs of triangles; stats() counts those that became the nearest.
  [[nodiscard]] uint32_t triangle_tests() const { return this->tested; }

  /// Does at most `work`; UINT32_MAX: no limit. As Query::run().
  FLASHBVH_INLINE RunResult run(uint32_t work) {
    uint32_t left = work;
    const Status status = run_within(left);
    return {status, 0, work - left};
  }
  /// Does at most `work` and leaves the remainder in it; UINT32_MAX does not change.
  Status run_within(uint32_t& work);

  /// Returns the distance as far as it is known.
  Clearance<Index> result() const;

  /// Returns the nearest triangles so far, in cells of A's frame. Not valid while result().upper is
  /// UINT32_MAX, nor out of range.
  void nearest_triangles(Triangle& a, Triangle& b) const {
    detail::place_pair(this->mesh_a(), this->nearest_a, this->mesh_b(), this->nearest_b,
                       this->transform(), a, b);
  }

  /// Returns the cursor. Valid between runs.
  [[nodiscard]] QueryCursor<Index> cursor() const {
    QueryCursor<Index> at = Base::cursor();
    at.has_witness = !this->has_nearest ? 0 : this->is_coarse ? 2 : 1;
    at.witness_a = this->nearest_a;
    at.witness_b = this->nearest_b;
    return at;
  }
  /// As Query::resume(); the distance is recomputed from the witness.
  Status resume(const QueryCursor<Index>& at);

 private:
  static Predicate predicate(uint16_t tolerance) {
    Predicate made;
    made.allowance = tolerance;
    return made;
  }
  FLASHBVH_NOINLINE bool may_be_coarse() const;
  FLASHBVH_NOINLINE void set_coarse(bool coarse);
  /// Kept out of line so that its frame is gone before `run()`.
  void begin_at(const Pose& pose, const Hint& hint);
  /// Writes A's triangle, then B's, relative to A's origin.
  FLASHBVH_NOINLINE void get_pair(uint32_t i, uint32_t j, Triangle (&pair)[2]) const;
  /// Starts with a pair of triangles as the nearest. Returns the squared gap of their boxes.
  int64_t begin_with(const Hint& pair);
  /// True if a hint with this gap would cost more than it saves: the query drops it.
  bool is_stale(int64_t squared_gap) const;
  /// Makes these slots' triangles the nearest if they are; false if they are not.
  FLASHBVH_NOINLINE bool take(uint32_t i, uint32_t j);
  /// Tests the triangles of the leaves where the descent ended.
  void take_leaves(uint32_t& work);
  /// Descends from the node of the larger rank to its child nearest to the other node; false if
  /// both are leaves. Until a pair is found, the nearest triangles' slots hold the current nodes.
  FLASHBVH_NOINLINE bool descend(uint32_t& work);
};

using ClearanceQuery = BasicClearanceQuery<Mesh>;

/// Returns the distance in one call, which ends when the answer is complete. Errors are those of
/// ClearanceQuery, which also runs in slices.
template <class Index>
Clearance<Index> distance(const BasicMesh<Index, Layout::post_indexed>& a,
                          const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose,
                          const Witness<Index>& hint = Witness<Index>()) {
  BasicClearanceQuery<BasicMesh<Index, Layout::post_indexed>> query(a, b, pose, hint);
  uint32_t work = UINT32_MAX;
  (void)query.run_within(work);
  return query.result();
}

// Compiled once, in the library.
FLASHBVH_COMPILED_QUERY_RUN(extern, Ranked<Mesh>, Within);
FLASHBVH_COMPILED_QUERY_RUN(extern, Ranked<Mesh32>, Within);
extern template class Query<Ranked<Mesh>, Within>;
extern template class Query<Ranked<Mesh32>, Within>;
extern template class BasicClearanceQuery<Mesh>;
extern template class BasicClearanceQuery<Mesh32>;

}  // namespace flashbvh
