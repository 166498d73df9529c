// A collision query between two baked meshes: finds the triangles of A and B that intersect.
//
// The query object is all the memory that a query needs. It may stop after any amount of work and
// gives the same pairs in the same order, however it is cut into runs.
//
// Work: a visit to a pair of boxes is 1. Preparing the planes of a leaf is 8, plus 1 for each
// triangle after its first. Testing two triangles is 32. In a band (clearance.hpp) it is 8, and 32
// more if only the exact distance decides. The work of a run bounds its time (time_bound.hpp,
// lib/docs/bounded_time.md).
//
// A query writes only to itself and to the caller's array. So any number of queries, in tasks and
// in interrupts, may share meshes and poses. A query has one caller at a time: an interrupt of its
// run must not touch it.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/query/query_run.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// `Traversal`: Ranked<Mesh>, or one of traversal/*.hpp: Query<Stackless>. The meshes and
/// the pose must outlive the query. 128 bytes on a 32-bit core with 16-bit indices.
template <class Traversal, class Predicate = detail::Intersection>
class Query : protected detail::QueryRun<Traversal, Predicate> {
  using Base = detail::QueryRun<Traversal, Predicate>;
  using State = QueryState;
  using Base::a_, Base::b_, Base::cursor_, Base::error_, Base::state_, Base::stats_;
  using Base::of_a, Base::of_b, Base::transform_, Base::untested_;

 public:
  using Mesh = typename Traversal::Tree;
  using Index = typename Mesh::Index;
  using Cursor = typename Traversal::Cursor;
  using Pair = TrianglePair<Index>;

  /// B is at `pose` in A's frame. status() and every run return errors.
  ///
  /// Instructions on a Cortex-M4 at -O2: about 60 under a translation. Under a rotation about 190
  /// if the objects are far apart, which the query detects, and at most 1,000. With the
  /// first visit about 400 and 1,070.
  FLASHBVH_INLINE_TO_RUN Query(const Mesh& a, const Mesh& b, const Pose& pose,
                               const Cursor& start = Cursor(),
                               const Predicate& predicate = Predicate())
      : Base(a, b, pose, start, predicate) {}

  /// Rejects temporary meshes and poses, which would be gone before the first run.
  Query(const Mesh&&, const Mesh&, const Pose&, const Cursor& = Cursor(),
        const Predicate& = Predicate()) = delete;
  Query(const Mesh&, const Mesh&&, const Pose&, const Cursor& = Cursor(),
        const Predicate& = Predicate()) = delete;
  Query(const Mesh&, const Mesh&, const Pose&&, const Cursor& = Cursor(),
        const Predicate& = Predicate()) = delete;

  /// `suspended` while there is work left.
  using Base::status;
  /// Returns the counts so far, also inside a sink.
  [[nodiscard]] const QueryStats& stats() const { return stats_; }

  /// Does at most `work`, and writes at most `capacity` pairs to `found`. Returns `done`;
  /// `suspended` if the work is spent; `full` as soon as the array is; or an error. After
  /// `suspended` and `full` the next run resumes at this point. Any non-zero `work` makes progress:
  /// the last step may cost more than is left. UINT32_MAX: no limit.
  ///
  /// Stack on Cortex-M3 to M55 at -O2: at most 600 bytes. Instructions: time_bound.hpp.
  FLASHBVH_INLINE RunResult run(uint32_t work, Pair* found, uint32_t capacity) {
    uint32_t count = 0;
    if (capacity == 0 && status() == Status::suspended) {
      return {Status::full, 0, 0};
    }
    const auto sink = [&](const Pair& pair) {
      found[count++] = pair;
      return count < capacity;
    };
    uint32_t left = work;
    const Status end = this->run_with(left, sink, [&] { return capacity - count; });
    return {end, count, work - left};
  }

  /// Runs with an array of fixed length.
  template <uint32_t capacity>
  FLASHBVH_INLINE RunResult run(uint32_t work, Pair (&found)[capacity]) {
    return run(work, found, capacity);
  }

  /// Passes each pair to `sink(pair)` and counts it; if `sink` returns false, the run ends with
  /// `full` after the pair.
  ///
  /// If the sink stops at a pair, the next run repeats part of the walk; stats() counts it once.
  template <class Sink>
  FLASHBVH_INLINE RunResult run(uint32_t work, Sink&& sink) {
    uint32_t count = 0;
    const auto counting = [&](const Pair& pair) {
      ++count;
      return sink(pair);
    };
    uint32_t left = work;
    const Status end = this->run_with(left, counting, [] { return UINT32_MAX; });
    return {end, count, work - left};
  }

  /// Returns the cursor. Valid between runs; not for traversals with a stack.
  [[nodiscard]] QueryCursor<Index> cursor() const {
    return {cursor_.a, cursor_.b, untested_, state_, 0, 0, 0};
  }

  /// Resumes from the cursor of a query on the same meshes and pose; counts continue from their
  /// current values. `cursor_invalid`, and nothing changes, if no query on these meshes can have
  /// such a cursor. A cursor of another pose or other meshes is not detected if it is possible in
  /// this query. The run then gives the pairs after it.
  Status resume(const QueryCursor<Index>& at) {
    if (error_ != Status::done) {
      return error_;
    }
    if (!this->is_possible(at)) {
      return Status::cursor_invalid;
    }
    cursor_ = {at.a, at.b};
    state_ = at.state;
    untested_ = state_ == State::at_leaf_pair ? at.untested : 0;
    if (state_ == State::fresh) {
      cursor_ = Cursor();
    } else if (state_ != State::done) {
      transform_.prepare(*b_);
      this->set_leaves();
    }
    return status();
  }

  /// Returns the triangles of the last reported pair, in cells of A's frame. Valid inside a sink,
  /// and after a run that wrote a pair and ended with `full`.
  void last_pair(Triangle& a, Triangle& b) const {
    detail::place_pair(*a_, of_a(untested_), *b_, of_b(untested_), transform_, a, b);
  }
  /// Returns the slots of these triangles in the meshes' arrays, not their ids, as hints hold them
  /// (clearance.hpp). Valid when last_pair() is. A template, so that compiled libraries have it
  /// only where it is called.
  template <class Positions = Pair>
  [[nodiscard]] Positions last_slots() const {
    return {static_cast<Index>(of_a(untested_)), static_cast<Index>(of_b(untested_))};
  }
};

/// Leaves reject pairs by their boxes alone, as in the paper's counts; answers are the same.
using BoxIntersection = detail::BoxIntersection;

/// The default query.
using PairQuery = Query<Ranked<Mesh>>;

// Compiled once, in the library.
FLASHBVH_COMPILED_QUERY_RUN(extern, Ranked<Mesh>, detail::Intersection);
FLASHBVH_COMPILED_QUERY_RUN(extern, Ranked<Mesh32>, detail::Intersection);
extern template class Query<Ranked<Mesh>>;
extern template class Query<Ranked<Mesh32>>;

}  // namespace flashbvh
