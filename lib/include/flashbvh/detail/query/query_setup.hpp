// A query's state, and how it is made: meshes, pose and predicate are checked, and B is placed.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/query/intersection.hpp"
#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/status.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// The state of a query between its runs. Its constructor records the first error.
template <class Traversal, class Predicate>
class QuerySetup : protected Predicate {
 protected:
  using Mesh = typename Traversal::Tree;
  using Index = typename Mesh::Index;
  using Cursor = typename Traversal::Cursor;

  FLASHBVH_INLINE_TO_RUN QuerySetup(const Mesh& a, const Mesh& b, const Pose& pose,
                                    const Cursor& start, const Predicate& predicate)
      : QuerySetup(EndsAtRoots<kEndsAtRoots>(), a, b, pose, start, predicate) {}

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
  /// Walks from the roots once more.
  void restart() {
    cursor_ = Cursor();
    state_ = State::fresh;
    untested_ = 0;
  }
  /// Counts a visit outside the walk.
  void count_visit() { ++stats_.visits; }

  /// True if a query on these meshes can have this cursor. Kept out of line: inlined, it takes
  /// registers from callers, which then need 16 bytes more.
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

  /// True if disjoint roots end the query with its first visit.
  static constexpr bool kEndsAtRoots = Traversal::kStartsAtRoots && Predicate::kDisjointRootsEnd;

 private:
  static Status error_of(const Mesh& a, const Mesh& b, const Pose& pose, const Cursor& start) {
    if (!have_one_cell(a, b)) {
      return cell_error(a, b);
    }
    if (pose.status() != Status::done) {
      return pose.status();
    }
    return start.fits(a, b) ? Status::done : Status::stack_too_small;
  }

  template <bool>
  struct EndsAtRoots {};
  FLASHBVH_INLINE_TO_RUN QuerySetup(EndsAtRoots<true>, const Mesh& a, const Mesh& b,
                                    const Pose& pose, const Cursor& start,
                                    const Predicate& predicate)
      : Predicate(predicate), cursor_(start) {
    const Status wrong = error_of(a, b, pose, start);
    if (__builtin_expect(wrong == Status::done, 1)) {
      transform_.place(pose, a, b, true, [&] { begin(a, b, Status::done); });
    } else {
      transform_.place_nowhere();
      begin(a, b, wrong);
    }
  }
  FLASHBVH_INLINE_TO_RUN QuerySetup(EndsAtRoots<false>, const Mesh& a, const Mesh& b,
                                    const Pose& pose, const Cursor& start,
                                    const Predicate& predicate)
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

 protected:
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
