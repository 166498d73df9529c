// A collision query between two baked meshes: which triangles of A intersect which triangles of B.
//
// The query object is all the memory there is. It may be stopped after any amount of work and gives
// the same pairs in the same order however it is cut into runs.
//
// Work: a visit to a pair of boxes is 1; a leaf taken as a shape 8, and 1 for each triangle beside
// its first; two triangles tested against each other 32, or 8 where they are asked whether they are
// within a distance. The work of a run bounds its time (time_bound.hpp, lib/docs/bounded_time.md).
//
// A query writes nothing but itself and the caller's array, so any number of queries, in tasks and
// in interrupts, may share meshes and poses. One query is one caller's at a time: what interrupts a
// run of it may not touch it.
#ifndef FLASHBVH_QUERY_HPP
#define FLASHBVH_QUERY_HPP

#include <stdint.h>

#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/query/intersection.hpp"
#include "flashbvh/detail/query/leaf_triangles.hpp"
#include "flashbvh/detail/query/triangle_test.hpp"
#include "flashbvh/detail/walk/leaf_pairs.hpp"
#include "flashbvh/detail/walk/leaf_planes.hpp"
#include "flashbvh/detail/walk/ranked.hpp"
#include "flashbvh/detail/walk/walk.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/run_result.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// `Traversal`: Ranked<Mesh>, or a class with the same members (detail/walk/walk.hpp). The meshes
/// and the pose outlive the query. 128 bytes on a 32-bit core with 16-bit indices.
template <class Traversal, class Predicate = detail::Intersection>
class Query : protected Predicate {
  using State = detail::State;

 public:
  using Mesh = typename Traversal::Tree;
  using Index = typename Mesh::Index;
  using Cursor = typename Traversal::Cursor;
  using Pair = TrianglePair<Index>;

  /// B lies at `pose` in A's frame. Orders with a stack take their array as `start`; the stackless
  /// ones need nothing. Errors show in status() and in every run.
  ///
  /// Instructions on a Cortex-M4 at -O2: about 60 under a translation; under a rotation about 190
  /// if the objects are far apart, which it tells, and at most 720 (lib/docs/figures.md, "start",
  /// has what the first run adds).
  FLASHBVH_INLINE_TO_RUN Query(const Mesh& a, const Mesh& b, const Pose& pose,
                               const Cursor& start = Cursor(),
                               const Predicate& predicate = Predicate())
      : Query(EndsAtRoots<kEndsAtRoots>(), a, b, pose, start, predicate) {}

  /// Meshes and poses that would be gone before the first run.
  Query(const Mesh&&, const Mesh&, const Pose&, const Cursor& = Cursor()) = delete;
  Query(const Mesh&, const Mesh&&, const Pose&, const Cursor& = Cursor()) = delete;
  Query(const Mesh&, const Mesh&, const Pose&&, const Cursor& = Cursor()) = delete;

  /// `suspended` while there is something left to do.
  Status status() const {
    return error_ != Status::done  ? error_
           : state_ == State::done ? Status::done
                                   : Status::suspended;
  }
  /// What was done so far, inside a sink too.
  [[nodiscard]] const QueryStats& stats() const { return stats_; }

  /// Does at most `work`, and writes at most `capacity` pairs to `found`.
  /// Returns `done`; `suspended` when the work is done; `full` as soon as the array is; or an
  /// error. After `suspended` and `full` the next run goes on where this one ended. With work of 1
  /// or more it always gets on: the step that it can't quite pay for is done, and is the last.
  /// UINT32_MAX: all there is to do.
  ///
  /// Stack on Cortex-M3 to M55 at -O2: 544 bytes. Instructions: time_bound.hpp.
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
    const Status status = run_with(left, sink, [&] { return capacity - count; });
    return {status, count, work - left};
  }

  /// Runs into an array of known length.
  template <uint32_t capacity>
  FLASHBVH_INLINE RunResult run(uint32_t work, Pair (&found)[capacity]) {
    return run(work, found, capacity);
  }

  /// Hands each pair to `sink(pair)` and counts it; if that returns false, the run ends with `full`
  /// after the pair.
  ///
  /// The walk takes along up to eight pairs of leaves before it comes back and their triangles are
  /// tested, so that its stack and that of the triangle test are never needed at once. Of those
  /// that a sink stops at the walk is done again by the next run; counts know them once.
  template <class Sink>
  FLASHBVH_INLINE RunResult run(uint32_t work, Sink&& sink) {
    uint32_t count = 0;
    const auto counting = [&](const Pair& pair) {
      ++count;
      return sink(pair);
    };
    uint32_t left = work;
    const Status status = run_with(left, counting, [] { return UINT32_MAX; });
    return {status, count, work - left};
  }

  /// Where the query stands. Between runs; not for orders with a stack.
  [[nodiscard]] QueryCursor<Index> cursor() const {
    return {cursor_.a, cursor_.b, untested_, state_, 0, 0, 0};
  }

  /// Goes on from a cursor of a query on the same meshes and pose; counts go on from what they
  /// are. `cursor_invalid`, and nothing changes, if no query on these meshes has such a cursor.
  /// That it is one of another pose, or of other meshes, is not told where it could be one of this
  /// query; the run then gives the pairs after it.
  Status resume(const QueryCursor<Index>& at) {
    if (error_ != Status::done) {
      return error_;
    }
    if (!is_possible(at)) {
      return Status::cursor_invalid;
    }
    cursor_ = {at.a, at.b};
    state_ = at.state;
    untested_ = state_ == State::at_leaf_pair ? at.untested : 0;
    if (state_ == State::fresh) {
      cursor_ = Cursor();
    } else if (state_ != State::done) {
      transform_.prepare(*b_);
      set_leaves();
    }
    return status();
  }

  /// The triangles of the pair reported last, in A's frame, in cells: inside a sink, and after a
  /// run that wrote a pair and ended with `full`.
  void last_pair(Triangle& a, Triangle& b) const {
    detail::place_pair(*a_, of_a(untested_), *b_, of_b(untested_), transform_, a, b);
  }
  /// Their positions in the meshes' arrays, not their ids: as hints are (clearance.hpp). Likewise.
  /// A template, so that what is compiled once has it where it is asked for alone.
  template <class Positions = Pair>
  [[nodiscard]] Positions last_slots() const {
    return {static_cast<Index>(of_a(untested_)), static_cast<Index>(of_b(untested_))};
  }

 protected:
  /// For queries that are made of this one: what it is asked of.
  [[nodiscard]] const Mesh& mesh_a() const { return *a_; }
  /// Likewise.
  [[nodiscard]] const Mesh& mesh_b() const { return *b_; }
  /// Where B lies.
  [[nodiscard]] const detail::Transform& transform() const { return transform_; }
  /// What is wrong with meshes, pose and question; `done`: nothing.
  [[nodiscard]] Status error() const { return error_; }
  /// Of what is wrong beside them.
  void refuse(Status error) { error_ = error; }
  /// A visit that was made beside the walk.
  void count_visit() { ++stats_.visits; }
  /// Runs and leaves in `work` what is left of it. `room()`: for how many more pairs `sink` has
  /// capacity, which spares walking on after the last of them.
  template <class Sink, class Room>
  FLASHBVH_INLINE Status run_with(uint32_t& work, Sink&& sink, const Room& room) {
    if (error_ != Status::done || state_ == State::done) {
      return status();
    }
    if (state_ == State::fresh) {
      if (work == 0) {
        return Status::suspended;
      }
      if (kEndsAtRoots && transform_.roots_disjoint()) {
        work -= work == detail::kUnlimited ? 0 : 1;
        stats_.visits = 1;
        state_ = State::done;
        return Status::done;
      }
      transform_.prepare(*b_);
    }
    uint32_t left = work;  // in memory from here on only
    const Status status = go_on(left, sink, room);
    work = left;
    return status;
  }

 private:
  /// Positions of the current pair of triangles: the leaves' pairs are taken from the last one on,
  /// all of A's for each of B's.
  /// The pair due is the one before `untested_`, the pair tested last that at it.
  uint32_t of_a(uint32_t i) const {
    return a_->first_triangle(leaf_a_) + i % a_->triangles_in(leaf_a_);
  }
  uint32_t of_b(uint32_t i) const {
    return b_->first_triangle(leaf_b_) + i / a_->triangles_in(leaf_a_);
  }
  Pair current_pair() const {
    return {a_->triangle_ids[of_a(untested_)], b_->triangle_ids[of_b(untested_)]};
  }

  void set_leaves() {
    const detail::PairCursor<Index> nodes = Traversal::nodes(*a_, *b_, cursor_);
    leaf_a_ = a_->nodes[nodes.a].leaf();
    leaf_b_ = b_->nodes[nodes.b].leaf();
  }

  /// Orders with a stack can't go back to a pair, so they take along but one.
  using Batches = detail::Batches<
      detail::LeafPairs<Mesh, Traversal::kStackless ? Predicate::kBatch : 1, Predicate::kPairWork>,
      Mesh, detail::kAsksAllAlike<Predicate>>;
  using Batch = typename Batches::Batch;
  using Shapes = typename Predicate::template Shapes<Mesh>;
  using Kept = detail::KeptShapes<Shapes, Predicate::kKeepsShapes>;
  using Test = detail::TriangleTest<Predicate, Mesh, Predicate::kIntersects>;

  template <class Sink, class Room>
  FLASHBVH_INLINE Status go_on(uint32_t& work, Sink& sink, const Room& room) {
    Batch batch(*a_, *b_);
    typename Kept::Shapes shapes(*a_, *b_, transform_);
    State end = state_;
    for (;;) {
      const uint32_t kept = untested_ == 0 ? 0 : pay(untested_, work);
      while (next_answer(batch, kept)) {
        if (!sink(current_pair())) {
          stop_at_current(batch);
          pay_dear(work);
          return Status::full;
        }
      }
      pay_dear(work);
      state_ = end;
      if (end == State::done || work == 0) {
        return status();
      }
      if (untested_ == 0) {
        end = walk(work, batch, shapes, room());
      }
    }
  }

  /// Pays for pairs of triangles, all of them or as many as work allows; how many are kept for
  /// another run.
  static uint32_t pay(uint32_t pairs, uint32_t& work) {
    const uint32_t paid = detail::triangle_pairs_for<Predicate::kPairWork>(work);
    detail::take_work(work, pairs * Predicate::kPairWork);
    return paid < pairs ? pairs - paid : 0;
  }

  /// For what tests took that kPairWork is not for.
  void pay_dear(uint32_t& work) {
    if constexpr (Predicate::kDearWork != 0) {
      detail::take_work(work, this->dear_tests * Predicate::kDearWork);
      this->dear_tests = 0;
    }
  }

  /// What the walk found after the pair at hand, it will find again.
  void stop_at_current(const Batch& batch) {
    if constexpr (Traversal::kStackless) {
      if (batch.has_current()) {
        cursor_ = Traversal::cursor_at(*a_, *b_, batch.current().a, batch.current().b);
      }
    }
    state_ = State::at_leaf_pair;
  }

  bool is_possible(const QueryCursor<Index>& at) const {
    if (at.state != State::at_pair && at.state != State::at_leaf_pair) {
      return at.state == State::fresh || at.state == State::done;
    }
    const Cursor cursor = {at.a, at.b};
    if (transform_.is_far_apart() || at.a >= a_->node_count || at.b >= b_->node_count ||
        !Traversal::can_visit(*a_, *b_, cursor)) {
      return false;
    }
    if (at.state == State::at_pair) {
      return true;
    }
    const detail::PairCursor<Index> nodes = Traversal::nodes(*a_, *b_, cursor);
    return a_->nodes[nodes.a].is_leaf() && b_->nodes[nodes.b].is_leaf() &&
           at.untested <= a_->triangles_in(a_->nodes[nodes.a].leaf()) *
                              b_->triangles_in(b_->nodes[nodes.b].leaf());
  }

  static Status error_of(const Mesh& a, const Mesh& b, const Pose& pose, const Cursor& start) {
    if (a.cell_bits != b.cell_bits) {
      return Status::cell_mismatch;
    }
    if (pose.status() != Status::done) {
      return pose.status();
    }
    return start.fits(a, b) ? Status::done : Status::stack_too_small;
  }

  /// Whether roots that are disjoint end the query with its first visit.
  static constexpr bool kEndsAtRoots = Traversal::kStartsAtRoots && Predicate::kDisjointRootsEnd;
  template <bool>
  struct EndsAtRoots {};
  FLASHBVH_INLINE_TO_RUN Query(EndsAtRoots<true>, const Mesh& a, const Mesh& b, const Pose& pose,
                               const Cursor& start, const Predicate& predicate)
      : Predicate(predicate), cursor_(start) {
    const Status wrong = error_of(a, b, pose, start);
    if (__builtin_expect(wrong == Status::done, 1)) {
      transform_.place(pose, a, b, true, [&] { begin(a, b, Status::done); });
    } else {
      transform_.place_nowhere();
      begin(a, b, wrong);
    }
  }
  FLASHBVH_INLINE_TO_RUN Query(EndsAtRoots<false>, const Mesh& a, const Mesh& b, const Pose& pose,
                               const Cursor& start, const Predicate& predicate)
      : Predicate(predicate), a_(&a), b_(&b), cursor_(start) {
    place_and_begin(pose);
  }
  /// With no part in the caller's frame.
  FLASHBVH_NOINLINE void place_and_begin(const Pose& pose) {
    begin(*a_, *b_, error_of(*a_, *b_, pose, cursor_));
    if (error_ == Status::done) {
      transform_.place(pose, *a_, *b_, false, [] {});
    } else {
      transform_.place_nowhere();
    }
    if constexpr (!Predicate::kDisjointRootsEnd) {
      transform_.bring_near();
      const Predicate& predicate = *this;
      error_ = error_ != Status::done ? error_ : predicate.error_of(transform_, *a_, *b_);
    }
  }
  /// Sets all but the transform and the cursor.
  void begin(const Mesh& a, const Mesh& b, Status error) {
    a_ = &a;
    b_ = &b;
    stats_ = detail::no_counts();
    leaf_a_ = 0;
    leaf_b_ = 0;
    untested_ = 0;
    state_ = State::fresh;
    error_ = error;
  }
  /// Until the batch is full, to the end, or to that of the work.
  FLASHBVH_NOINLINE State walk(uint32_t& work, Batch& batch, typename Kept::Shapes& kept,
                               uint32_t room) {
    typename Kept::AtHand shapes = Kept::at_hand(kept, *a_, *b_, transform_);
    const uint32_t granted = work < Batch::kMostWork ? work : Batch::kMostWork;
    detail::WalkRun<Cursor, Batch> run(cursor_, batch, granted);
    batch.clear(run.progress, room, Predicate::kIntersects && state_ == State::fresh);
    const State end = detail::StatefulBoxTest<Predicate>::is_for(*this, transform_)
                          ? walk_rotated(shapes, run)
                          : walk_translated(shapes, run);
    batch.end(run.progress);
    uint32_t spent = granted - run.progress.work_left;
    if (granted == Batch::kMostWork && (end == State::at_pair || batch.has_unpaid())) {
      spent += Predicate::kPairWork;  // for another walk
    }
    detail::take_work(work, spent);
    return end;
  }
  FLASHBVH_NOINLINE State walk_translated(Shapes& shapes, detail::WalkRun<Cursor, Batch>& run) {
    const auto& bound = Predicate::translated(transform_.translated());
    if constexpr (Shapes::kReadsBoxTest) {
      shapes.set_box_test(bound);
    }
    return detail::walk<Traversal>(bound, shapes, run, state_);
  }
  FLASHBVH_NOINLINE State walk_rotated(Shapes& shapes, detail::WalkRun<Cursor, Batch>& run) {
    auto bound = detail::StatefulBoxTest<Predicate>::of(*this, transform_);
    shapes.set_box_test(bound);
    return detail::walk<Traversal>(detail::ByReference<decltype(bound)>{&bound}, shapes, run,
                                   state_);
  }

  /// Tests pairs of triangles until one is an answer; false if none is left of the batch.
  /// Transforming triangles, B's above all, is not done again while pairs share them.
  /// `kept`: how many of those at hand are not paid for. Nothing but `this` outlives the call,
  /// which keeps the stack flat where it is deepest.
  FLASHBVH_NOINLINE bool next_answer(Batch& batch, uint32_t kept) {
    if (Predicate::kIntersects && untested_ == 0 && !batch.is_walked()) {
      return false;  // before a run's first walk: with no registers saved
    }
    Predicate& predicate = *this;
    Test test(predicate, *a_, *b_, transform_);
    for (;;) {
      const uint32_t untested = untested_ > kept ? untested_ : take_next(batch);
      if (untested == 0) {
        return false;
      }
      bool answer = false;
      bool is_at_once = false;
      if constexpr (Batches::kAtOnce) {
        is_at_once = batch.at_once.has(transform_, leaf_a_, leaf_b_);
        if (is_at_once) {
          untested_ = static_cast<uint16_t>(untested);
          answer = batch.at_once.next_answer(leaf_a_, leaf_b_, kept, untested_);
        }
      }
      if (!is_at_once) {
        answer = test_leaves(test, batch, kept, untested);
      }
      if (answer) {
        if (batch.has_current()) {
          count(batch.walked_to_current());
        }
        ++stats_.triangle_pairs;
        return true;
      }
    }
  }

  /// Tests the pairs of triangles that the pair of leaves still has, down to an answer, or to those
  /// that are kept for another run.
  FLASHBVH_INLINE bool test_leaves(Test& test, const Batch& batch, uint32_t kept,
                                   uint32_t untested) {
    const uint32_t first_a = a_->first_triangle(leaf_a_);
    const uint32_t in_a = a_->end_triangle(leaf_a_) - first_a;
    uint32_t of_a = untested;  // of A's, with the first of B's
    uint32_t triangle_b = b_->first_triangle(leaf_b_);
    if (untested > in_a) {
      const uint32_t last = untested - 1;  // a run before this one may have stopped anywhere
      // No leaf is empty. NOLINTNEXTLINE(clang-analyzer-core.DivideZero)
      of_a = last % in_a + 1;
      triangle_b += last / in_a;
    }
    // A run that begins inside a pair of leaves does without.
    const detail::PackedBox* const box_a =
        batch.has_current() ? &a_->nodes[batch.current().a].box : nullptr;
    bool answer = false;
    for (;; of_a = in_a, --triangle_b) {
      untested -= of_a;
      if (test.take_b(triangle_b, box_a)) {
        do {
          --of_a;
          answer = test(first_a + of_a);
        } while (!answer && of_a != 0 && untested + of_a > kept);
        untested += of_a;
      }
      if (answer || untested <= kept) {
        untested_ = static_cast<uint16_t>(untested);
        return answer;
      }
    }
  }

  void count(const typename Batch::Walked& walked) {
    stats_.visits += walked.visits;
    stats_.overlaps += walked.overlaps;
  }

  /// The next pair of leaves, and how many pairs of triangles it has; 0 if there is none, or it is
  /// not paid for.
  FLASHBVH_INLINE_FOR_SPEED uint32_t take_next(Batch& batch) {
    const bool paid = batch.has_next();
    if (!paid && !batch.has_unpaid()) {
      count(batch.walked_to_end());
      return 0;
    }
    const auto& pair = batch.next();
    ++stats_.leaf_pairs;
    leaf_a_ = a_->nodes[pair.a].leaf();
    leaf_b_ = b_->nodes[pair.b].leaf();
    const uint32_t pairs = a_->triangles_in(leaf_a_) * b_->triangles_in(leaf_b_);
    if (paid) {
      return pairs;
    }
    count(batch.walked_to_current());
    untested_ = static_cast<uint16_t>(pairs);
    return 0;
  }

  // What is read most comes first, where short instructions reach it.
  const Mesh* a_;
  const Mesh* b_;
  QueryStats stats_;
  Cursor cursor_;
  Index leaf_a_;  ///< the cursor's pair of leaves, by number, once it is at one
  Index leaf_b_;
  uint16_t untested_;  ///< pairs of triangles that the cursor's pair of leaves still has
  State state_;
  Status error_;  ///< `done`: none
  detail::Transform transform_;
};

/// The default query, and the same for meshes with 32-bit indices.
using PairQuery = Query<Ranked<Mesh>>;
using PairQuery32 = Query<Ranked<Mesh32>>;

// Compiled once, in the library.
extern template class Query<Ranked<Mesh>>;
extern template class Query<Ranked<Mesh32>>;

}  // namespace flashbvh

#endif
