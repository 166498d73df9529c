// A query's run: walks that collect pairs of leaves alternate with tests of their triangles.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/query/leaf_tests.hpp"
#include "flashbvh/detail/walk/leaf_planes.hpp"
#include "flashbvh/detail/walk/walk.hpp"
#include "flashbvh/traversal/ranked.hpp"

namespace flashbvh::detail {

/// The base of Query. A walk batches up to eight pairs of leaves before their triangles are tested.
/// So the stacks of walk and triangle test are never needed at once.
template <class Traversal, class Predicate>
class QueryRun : protected LeafTests<Traversal, Predicate> {
  using Base = LeafTests<Traversal, Predicate>;

 protected:
  using Base::a_, Base::b_, Base::cursor_, Base::error_, Base::state_, Base::stats_;
  using Base::current_pair, Base::is_made, Base::next_answer, Base::status;
  using Base::transform_, Base::untested_;
  using typename Base::Batch, typename Base::Cursor, typename Base::Mesh;

  FLASHBVH_INLINE QueryRun(const Mesh& a, const Mesh& b, const Pose& pose, const Cursor& start,
                           const Predicate& predicate)
      : Base(a, b, pose, start, predicate) {}

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
      if (Base::kEndsAtRoots && transform_.roots_disjoint()) {
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
    const Status end = go_on(left, sink, room);
    work = left;
    return end;
  }

  using Shapes = typename Predicate::template Shapes<Mesh>;
  using Kept = KeptShapes<Shapes, Predicate::kKeepsShapes>;
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
};

}  // namespace flashbvh::detail

/// Declares (`keyword`: extern) or defines (none) a query's parts, which are compiled once.
#define FLASHBVH_COMPILED_QUERY_RUN(keyword, ...)         \
  keyword template class detail::QuerySetup<__VA_ARGS__>; \
  keyword template class detail::LeafTests<__VA_ARGS__>;  \
  keyword template class detail::QueryRun<__VA_ARGS__>
