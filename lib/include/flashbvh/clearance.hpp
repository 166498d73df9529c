// How far two meshes are apart: between which points, and whether by more than a distance.
//
// Exact on the lattice, as everything here: the distance is that of the two transformed meshes. It
// is decided as an exact fraction of square cells, and rounded down and up to 1/256 cell. It is a
// distance of surfaces, not of solids: a mesh wholly inside another one is as far from it as from
// its wall. Meshes that intersect have distance 0, and no depth: the least movement that parts two
// meshes is not a property of the place where they touch (two combs that interlock have none of
// that size at all). What pushes bodies apart is a band: all pairs within d (WithinQuery), each
// with its distance.
//
// Stack on Cortex-M3 to M55 at -O2, in bytes: a run 880, a result 944, distance() 1,120,
// closer_than() 880 (proofs/stack). Budgets of work cut these queries as any other, but what a
// unit of it takes is proven of PairQuery alone (time_bound.hpp): two triangles take more here.
//
// Distances are in cells and 1/256 of them; float.hpp and units.hpp turn them into lengths.
#ifndef FLASHBVH_CLEARANCE_HPP
#define FLASHBVH_CLEARANCE_HPP

#include <stdint.h>

#include "flashbvh/collide.hpp"
#include "flashbvh/detail/query/nearest.hpp"
#include "flashbvh/detail/query/proximity.hpp"
#include "flashbvh/query.hpp"
#include "flashbvh/triangle.hpp"

namespace flashbvh {

/// The largest distance of a query, in 1/256 cell: 2^20 cells.
constexpr uint32_t kMaxDistance = detail::Within::kMost;

/// Every pair of triangles within a distance, in the order and the slices of a PairQuery: a Query
/// (query.hpp) that is made of meshes, a pose and the predicate `within(distance)`.
using Within = detail::Within;
using WithinQuery = Query<Ranked<Mesh>, Within>;
using WithinQuery32 = Query<Ranked<Mesh32>, Within>;

/// `distance`: in 1/256 cell, at most kMaxDistance; a query beyond it ends with
/// `distance_out_of_range`.
inline Within within(uint32_t distance) {
  return Within(distance);
}

/// Whether any points of the two meshes are at most `distance` apart, in 1/256 cell; ends at the
/// first pair of triangles that are.
/// `distance_out_of_range`: it is more than kMaxDistance, or B's lattice lies 2^20 cells or more
/// along an axis from A's, and whether it is within so large a distance is not decidable; `yes`
/// then.
template <class Index>
Answer closer_than(const BasicMesh<Index, Layout::post_indexed>& a,
                   const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose,
                   uint32_t distance) {
  Query<Ranked<BasicMesh<Index, Layout::post_indexed>>, Within> query(a, b, pose, {},
                                                                      within(distance));
  TrianglePair<Index> found;
  return detail::answer_of(query.run(UINT32_MAX, &found, 1).status);
}

/// What is known of a distance.
template <class Index>
struct [[nodiscard]] Clearance {
  /// `done`; `suspended`: not all was looked at; or an error, and nothing else holds.
  Status status;
  /// False: B lies 2^20 cells or more along an axis from A, lattice from lattice. `lower` and
  /// `upper` hold; no triangles, no witness and no points are reported.
  bool in_range;
  /// In 1/256 cell: the distance is at least this, rounded down; 0 while suspended.
  uint32_t lower;
  /// The distance is at most this, rounded up: in range that of these triangles. UINT32_MAX if none
  /// is known yet, or if it may be so much or more.
  uint32_t upper;
  TrianglePair<Index> triangles;  ///< by their ids
  Witness<Index> witness;         ///< the same, as a hint for the next query
  FinePoint point_a;              ///< where they are nearest
  FinePoint point_b;
  UnitVector direction;  ///< from point_a to point_b
};

/// What a query of a distance may begin with.
template <class Index>
struct ClearanceOptions {
  Witness<Index> hint = {};  ///< a pair that may be near: the nearest of the pose before
  /// In 2^-16: the distance reported may be larger than the true one by so much of that, and as
  /// much larger than `lower`, but for what both are rounded by.
  uint16_t tolerance = 0;
};

/// The distance of two meshes, in slices. With the last nearest pair as `hint` it visits hardly
/// more than the boxes that are nearer than the answer; without one it first goes down both trees
/// to where they seem nearest. A hint is dropped if its triangles lie some 70 % as far apart as the
/// middles of the meshes, or farther. Instructions on each core: lib/docs/figures.md, Distances.
/// The distance never depends on the hint; where several pairs are nearest, the reported one may.
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

  /// `hint_invalid`: it is no pair of these meshes' triangles.
  BasicClearanceQuery(const Mesh& a, const Mesh& b, const Pose& pose,
                      const Options& options = Options())
      : Base(a, b, pose, {}, predicate(options.tolerance)) {
    begin_at(pose, options.hint);
  }
  /// With a hint alone.
  BasicClearanceQuery(const Mesh& a, const Mesh& b, const Pose& pose, const Hint& hint)
      : Base(a, b, pose, {}, predicate(0)) {
    begin_at(pose, hint);
  }
  template <class... With>
  BasicClearanceQuery(const Mesh&&, const Mesh&, const Pose&, const With&...) = delete;
  template <class... With>
  BasicClearanceQuery(const Mesh&, const Mesh&&, const Pose&, const With&...) = delete;
  template <class... With>
  BasicClearanceQuery(const Mesh&, const Mesh&, const Pose&&, const With&...) = delete;

  /// `suspended` while there is something left to do.
  Status status() const {
    return this->error() == Status::done && this->intersect ? Status::done : Base::status();
  }
  using Base::stats;
  /// How many pairs of triangles were tested; stats() has those that were the nearest for a while.
  [[nodiscard]] uint32_t triangle_tests() const { return this->tested; }

  /// Does at most `work`; UINT32_MAX: all there is to do. As Query::run().
  FLASHBVH_INLINE RunResult run(uint32_t work) {
    uint32_t left = work;
    const Status status = run_within(left);
    return {status, 0, work - left};
  }
  /// Does at most `work`, and leaves there what is left of it; UINT32_MAX stays.
  Status run_within(uint32_t& work);

  /// What is known by now.
  Clearance<Index> result() const;

  /// The triangles that are nearest by now, in A's frame, in cells. Not before there are any, where
  /// result().upper is UINT32_MAX, nor out of range.
  void nearest_triangles(Triangle& a, Triangle& b) const {
    detail::place_pair(this->mesh_a(), this->nearest_a, this->mesh_b(), this->nearest_b,
                       this->transform(), a, b);
  }

  /// Between runs.
  [[nodiscard]] QueryCursor<Index> cursor() const {
    QueryCursor<Index> at = Base::cursor();
    at.has_witness = this->has_nearest ? 1 : 0;
    at.witness_a = this->nearest_a;
    at.witness_b = this->nearest_b;
    return at;
  }
  /// As Query::resume(); the distance is worked out of the witness again.
  Status resume(const QueryCursor<Index>& at);

 private:
  static Predicate predicate(uint16_t tolerance) {
    Predicate made;
    made.allowance = tolerance;
    return made;
  }
  /// With no part in the caller's frame.
  void begin_at(const Pose& pose, const Hint& hint);
  /// A's, then B's, from A's origin on.
  FLASHBVH_NOINLINE void get_pair(uint32_t i, uint32_t j, Triangle (&pair)[2]) const;
  /// With a pair of triangles, which may be the nearest. Returns the square of their boxes' gap.
  int64_t begin_with(const Hint& pair);
  /// Whether a hint with so large a gap would cost more than it spares: it is dropped.
  bool is_stale(int64_t squared_gap) const;
  /// Of two triangles by their positions: they are nearest, if they are.
  FLASHBVH_NOINLINE bool take(uint32_t i, uint32_t j);
  /// Where the descent ended: of the triangles there.
  void take_leaves(uint32_t& work);
  /// To the children that are nearest of the node of the larger rank. While nothing is found, the
  /// place of the nearest triangles holds the nodes that this is at.
  /// False where both are leaves.
  FLASHBVH_NOINLINE bool descend(uint32_t& work);
};

using ClearanceQuery = BasicClearanceQuery<Mesh>;
using ClearanceQuery32 = BasicClearanceQuery<Mesh32>;

/// The distance in one call, which takes as long as the answer takes. For slices, ClearanceQuery;
/// errors are its own.
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
extern template class detail::QueryRun<Ranked<Mesh>, Within>;
extern template class detail::QueryRun<Ranked<Mesh32>, Within>;
extern template class Query<Ranked<Mesh>, Within>;
extern template class Query<Ranked<Mesh32>, Within>;
extern template class BasicClearanceQuery<Mesh>;
extern template class BasicClearanceQuery<Mesh32>;

}  // namespace flashbvh

#endif
