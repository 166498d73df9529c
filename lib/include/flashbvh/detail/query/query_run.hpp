// A query's run: walks that collect pairs of leaves alternate with tests of their triangles.
#ifndef FLASHBVH_DETAIL_QUERY_QUERY_RUN_HPP
#define FLASHBVH_DETAIL_QUERY_QUERY_RUN_HPP

#include <stdint.h>

#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/query/intersection.hpp"
#include "flashbvh/detail/query/triangle_test.hpp"
#include "flashbvh/detail/walk/leaf_pairs.hpp"
#include "flashbvh/detail/walk/leaf_planes.hpp"
#include "flashbvh/detail/walk/walk.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/status.hpp"
#include "flashbvh/traversal/ranked.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// The base of Query. A walk batches up to eight pairs of leaves before their triangles are tested.
/// So the stacks of walk and triangle test are never needed at once.
template <class Traversal, class Predicate>
class QueryRun : protected Predicate {
 protected:
  using Mesh = typename Traversal::Tree;
  using Index = typename Mesh::Index;
  using Cursor = typename Traversal::Cursor;
  using Pair = TrianglePair<Index>;

  FLASHBVH_INLINE_TO_RUN QueryRun(const Mesh& a, const Mesh& b, const Pose& pose,
                                  const Cursor& start, const Predicate& predicate)
      : QueryRun(EndsAtRoots<kEndsAtRoots>(), a, b, pose, start, predicate) {}

  /// `suspended` while there is something left to do.
  Status status() const {
    return error_ != Status::done  ? error_
           : state_ == State::done ? Status::done
                                   : Status::suspended;
  }
  /// False for an object of zeros, which no constructor made.
  [[nodiscard]] bool is_made() const { return b_ != nullptr; }
  /// For derived queries: A.
  [[nodiscard]] const Mesh& mesh_a() const { return *a_; }
  /// For derived queries: B.
  [[nodiscard]] const Mesh& mesh_b() const { return *b_; }
  /// B's placement.
  [[nodiscard]] const Transform& transform() const { return transform_; }
  /// The error of meshes, pose or predicate; `done`: none.
  [[nodiscard]] Status error() const { return error_; }
  /// Records an error found by a derived query.
  void refuse(Status error) { error_ = error; }
  /// For a derived query's steps before its first walk.
  void prepare() { transform_.prepare(*b_); }
  /// Removes the pair last handed to a sink from the counts.
  void uncount_pair() { --stats_.triangle_pairs; }
  /// Counts a visit outside the walk.
  void count_visit() { ++stats_.visits; }
  /// Runs, and leaves the remaining work in `work`. `room()`: the capacity of `sink` in pairs, so
  /// that no walk goes on after the last of them.
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
        work -= work == kUnlimited ? 0 : 1;
        stats_.visits = 1;
        state_ = State::done;
        return Status::done;
      }
      if (!is_made()) {
        return Status::not_open;
      }
      transform_.prepare(*b_);
    }
    uint32_t left = work;  // in memory only from here on
    const Status status = go_on(left, sink, room);
    work = left;
    return status;
  }

  /// Slots of the leaves' i-th pair of triangles. Pairs are tested from the last one down, all of
  /// A's triangles for each of B's. `untested_` - 1 is the next pair, `untested_` the last tested.
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
    const PairCursor<Index> nodes = Traversal::nodes(*a_, *b_, cursor_);
    leaf_a_ = a_->nodes[nodes.a].leaf();
    leaf_b_ = b_->nodes[nodes.b].leaf();
  }

  /// Traversals with a stack can't go back to a pair, so their batch is one pair.
  using Batch =
      LeafPairs<Mesh, Traversal::kStackless ? Predicate::kBatch : 1, Predicate::kPairWork>;
  using Shapes = typename Predicate::template Shapes<Mesh>;
  using Kept = KeptShapes<Shapes, Predicate::kKeepsShapes>;
  using Test = TriangleTest<Predicate, Mesh, Predicate::kIntersects>;

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
          pay_expensive(work);
          return Status::full;
        }
      }
      pay_expensive(work);
      state_ = end;
      if (end == State::done || work == 0) {
        return status();
      }
      if (untested_ == 0) {
        end = walk(work, batch, shapes, room());
      }
    }
  }

  /// Pays for pairs of triangles, as many as work allows. Returns the number left for another run.
  static uint32_t pay(uint32_t pairs, uint32_t& work) {
    const uint32_t paid = triangle_pairs_for<Predicate::kPairWork>(work);
    take_work(work, pairs * Predicate::kPairWork);
    return paid < pairs ? pairs - paid : 0;
  }

  /// Pays for the parts of tests that kPairWork does not cover.
  void pay_expensive(uint32_t& work) {
    if constexpr (Predicate::kExpensiveWork != 0) {
      take_work(work, this->expensive_tests * Predicate::kExpensiveWork);
      this->expensive_tests = 0;
    }
  }

  /// Stops at the current pair. The next walk finds the pairs after it again.
  void stop_at_current(const Batch& batch) {
    if constexpr (Traversal::kStackless) {
      if (batch.has_current()) {
        cursor_ = Traversal::cursor_at(*a_, *b_, batch.current().a, batch.current().b);
      }
    }
    state_ = State::at_leaf_pair;
  }

  /// Kept out of line: inlined, it takes registers from callers, which then need 16 bytes more.
  FLASHBVH_NOINLINE bool is_possible(const QueryCursor<Index>& at) const {
    if (at.state != State::at_pair && at.state != State::at_leaf_pair) {
      return at.state == State::fresh || at.state == State::done;
    }
    Cursor cursor;
    cursor.a = at.a;
    cursor.b = at.b;
    if (transform_.is_far_apart() || at.a >= a_->node_count || at.b >= b_->node_count ||
        !Traversal::can_visit(*a_, *b_, cursor)) {
      return false;
    }
    if (at.state == State::at_pair) {
      return true;
    }
    const PairCursor<Index> nodes = Traversal::nodes(*a_, *b_, cursor);
    return a_->nodes[nodes.a].is_leaf() && b_->nodes[nodes.b].is_leaf() &&
           at.untested <= a_->triangles_in(a_->nodes[nodes.a].leaf()) *
                              b_->triangles_in(b_->nodes[nodes.b].leaf());
  }

  static Status error_of(const Mesh& a, const Mesh& b, const Pose& pose, const Cursor& start) {
    if (!have_one_cell(a, b)) {
      return cell_error(a, b);
    }
    if (pose.status() != Status::done) {
      return pose.status();
    }
    return start.fits(a, b) ? Status::done : Status::stack_too_small;
  }

  /// True if disjoint roots end the query with its first visit.
  static constexpr bool kEndsAtRoots = Traversal::kStartsAtRoots && Predicate::kDisjointRootsEnd;
  template <bool>
  struct EndsAtRoots {};
  FLASHBVH_INLINE_TO_RUN QueryRun(EndsAtRoots<true>, const Mesh& a, const Mesh& b, const Pose& pose,
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
  FLASHBVH_INLINE_TO_RUN QueryRun(EndsAtRoots<false>, const Mesh& a, const Mesh& b,
                                  const Pose& pose, const Cursor& start, const Predicate& predicate)
      : Predicate(predicate), a_(&a), b_(&b), cursor_(start) {
    place_and_begin(pose);
  }
  /// Kept out of line so that its frame is gone before `run()`.
  FLASHBVH_NOINLINE void place_and_begin(const Pose& pose) {
    begin(*a_, *b_, error_of(*a_, *b_, pose, cursor_));
    if (error_ == Status::done) {
      transform_.place(pose, *a_, *b_, false, [] {});
    } else {
      transform_.place_nowhere();
    }
    if constexpr (!Predicate::kDisjointRootsEnd) {
      if constexpr (!SeesFar<Predicate>::kValue) {
        transform_.bring_near();
      } else if (!transform_.is_near()) {
        transform_.place_far(pose, a_->origin, b_->origin);
      }
      const Predicate& predicate = *this;
      error_ = error_ != Status::done ? error_ : predicate.error_of(transform_, *a_, *b_);
    }
  }
  /// Sets all but the transform and the cursor.
  void begin(const Mesh& a, const Mesh& b, Status error) {
    a_ = &a;
    b_ = &b;
    stats_ = no_counts();
    leaf_a_ = 0;
    leaf_b_ = 0;
    untested_ = 0;
    state_ = State::fresh;
    error_ = error;
  }
  /// The work of a walk beyond its visits, charged if its pairs do not pay for it.
  static constexpr uint32_t kWalkWork =
      Predicate::kPairWork < kNearPairWork ? kNearPairWork : Predicate::kPairWork;

  /// Walks until the batch is full, all pairs are visited or the work is used up.
  FLASHBVH_NOINLINE State walk(uint32_t& work, Batch& batch, typename Kept::Shapes& kept,
                               uint32_t room) {
    typename Kept::Current shapes = Kept::current(kept, *a_, *b_, transform_);
    const uint32_t granted = work < Batch::kMostWork ? work : Batch::kMostWork;
    WalkRun<Cursor, Batch> run(cursor_, batch, granted);
    batch.clear(run.progress, room, Predicate::kIntersects && state_ == State::fresh);
    const State end = walk_by_bound(shapes, run);
    batch.end(run.progress);
    uint32_t spent = granted - run.progress.work_left;
    if (granted == Batch::kMostWork && (end == State::at_pair || batch.has_unpaid())) {
      spent += kWalkWork;  // for another walk
    }
    take_work(work, spent);
    return end;
  }
  FLASHBVH_INLINE State walk_by_bound(Shapes& shapes, WalkRun<Cursor, Batch>& run) {
    if constexpr (StatefulBoxTest<Predicate>::kAlways) {
      return walk_rotated(shapes, run);
    } else {
      return StatefulBoxTest<Predicate>::is_for(*this, transform_) ? walk_rotated(shapes, run)
                                                                   : walk_translated(shapes, run);
    }
  }
  FLASHBVH_NOINLINE State walk_translated(Shapes& shapes, WalkRun<Cursor, Batch>& run) {
    const auto& bound = Predicate::translated(transform_.translated());
    if constexpr (Shapes::kReadsBoxTest) {
      shapes.set_box_test(bound);
    }
    return detail::walk<typename Traversal::OfTranslations>(bound, shapes, run, state_);
  }
  FLASHBVH_NOINLINE State walk_rotated(Shapes& shapes, WalkRun<Cursor, Batch>& run) {
    auto bound = StatefulBoxTest<Predicate>::of(*this, transform_);
    shapes.set_box_test(bound);
    return detail::walk<Traversal>(ByReference<decltype(bound)>{&bound}, shapes, run, state_);
  }

  /// Tests pairs of triangles until one is an answer; false if the batch has no more. Consecutive
  /// pairs share transformed triangles, mainly B's. `kept`: the current pairs that are not paid
  /// for. Only `this` outlives the call, which keeps the stack flat where it is deepest.
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
      if (test_leaves(test, batch, kept, untested)) {
        if (batch.has_current()) {
          count(batch.walked_to_current());
        }
        ++stats_.triangle_pairs;
        return true;
      }
    }
  }

  /// Tests the leaves' remaining pairs of triangles, down to an answer or to the `kept` pairs that
  /// wait for another run.
  FLASHBVH_INLINE bool test_leaves(Test& test, const Batch& batch, uint32_t kept,
                                   uint32_t untested) {
    const uint32_t first_a = a_->first_triangle(leaf_a_);
    const uint32_t in_a = a_->end_triangle(leaf_a_) - first_a;
    uint32_t of_a = untested;  // A's triangles for B's first one
    uint32_t triangle_b = b_->first_triangle(leaf_b_);
    if (untested > in_a) {
      const uint32_t last = untested - 1;  // a run before this one may have stopped anywhere
      // No leaf is empty. NOLINTNEXTLINE(clang-analyzer-core.DivideZero)
      of_a = last % in_a + 1;
      triangle_b += last / in_a;
    }
    // A run that begins inside a pair of leaves tests no box.
    const PackedBox* const box_a =
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

  /// Moves to the next pair of leaves. Returns its number of pairs of triangles; 0 if there is no
  /// pair of leaves, or it is not paid for.
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

  // The members read most come first, within reach of short instructions.
  const Mesh* a_;
  const Mesh* b_;
  QueryStats stats_;
  Cursor cursor_;
  Index leaf_a_;  ///< leaf numbers of the cursor's pair, once both are leaves
  Index leaf_b_;
  uint16_t untested_;  ///< remaining pairs of triangles of the cursor's leaves
  State state_;
  Status error_;  ///< `done`: none
  Transform transform_;
};

}  // namespace flashbvh::detail

#pragma GCC diagnostic pop

#endif
