// A collision query between two baked meshes: which triangles of A intersect which triangles of B.
//
// The query object is all the memory there is. It may be stopped after any number of visits and
// gives the same pairs in the same order however it is cut into runs.
//
// A query writes nothing but itself and the caller's array, so any number of queries, in tasks and
// in interrupts, may share meshes and poses. One query is one caller's at a time: what interrupts a
// run of it may not touch it.
#ifndef FLASHBVH_QUERY_HPP
#define FLASHBVH_QUERY_HPP

#include <stdint.h>

#include "flashbvh/detail/intersection.hpp"
#include "flashbvh/detail/ranked.hpp"
#include "flashbvh/detail/transform.hpp"
#include "flashbvh/detail/walk.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// Two triangles that intersect, by their ids: their numbers in the source meshes.
template <class Index>
struct TrianglePair {
  Index a;
  Index b;
};

/// What a run gave.
struct [[nodiscard]] Step {
  Status status;
  uint32_t count;  ///< entries written to the caller's array
};

/// Where a stackless query stands, between runs: all there is to keep of it beside what it was made
/// of, its meshes and its pose. May be stored for as long as one likes, as bytes too: 12 of them
/// with 16-bit indices.
template <class IndexType>
struct QueryPosition {
  using State = detail::State;

  IndexType a = 0;
  IndexType b = 0;
  uint32_t untested = 0;  ///< pairs of triangles that the pair of leaves still has
  State state = State::fresh;
};

/// `Order`: Ranked<PostMesh> or any other of paper/. The meshes and the pose outlive the query.
/// 124 bytes on a 32-bit core with 16-bit indices.
template <class Order, class Question = detail::Intersection>
class Query : Question {
  using State = detail::State;

 public:
  using Mesh = typename Order::Tree;
  using Index = typename Mesh::Index;
  using Cursor = typename Order::Cursor;
  using Pair = TrianglePair<Index>;

  /// B lies at `pose` in A's frame. Orders with a stack take their array as `start`; the stackless
  /// ones need nothing. Errors show in status() and in every run.
  ///
  /// Instructions on a Cortex-M4 at -O2: 30 under a translation, 400 under a rotation, which tells
  /// objects that are far apart (lib/docs/figures.md, "start", has what the first run adds).
  Query(const Mesh& a, const Mesh& b, const Pose& pose, const Cursor& start = Cursor(),
        const Question& question = Question())
      : Question(question),
        a_(&a),
        b_(&b),
        transform_(pose, a, b, Order::kStartsAtRoots && Question::kDisjointRootsEnd),
        counts_{0, 0, 0, 0},
        cursor_(start),
        untested_(0),
        state_(State::fresh),
        error_(error_of(a, b, pose, start)) {}

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
  [[nodiscard]] const Counts& counts() const { return counts_; }

  /// Makes at most `visits` visits and writes at most `capacity` pairs to `found`.
  /// Returns `done`; `suspended` after the last visit granted; `full` as soon as the array is; or
  /// an error. After `suspended` and `full` the next run goes on where this one ended.
  ///
  /// Stack on Cortex-M3 to M55 at -O2: 256 bytes. Instructions: bound.hpp.
  Step run(uint32_t visits, Pair* found, uint32_t capacity) {
    uint32_t count = 0;
    if (capacity == 0 && status() == Status::suspended) {
      return {Status::full, 0};
    }
    const Status status = run(visits, [&](const Pair& pair) {
      found[count++] = pair;
      return count < capacity;
    });
    return {status, count};
  }

  /// The same into an array of known length.
  template <uint32_t capacity>
  Step run(uint32_t visits, Pair (&found)[capacity]) {
    return run(visits, found, capacity);
  }

  /// Hands each pair to `sink(pair)`; if that returns false, the run ends with `full` after it.
  ///
  /// The walk comes back at each pair of leaves, so that its stack and that of the triangle test
  /// are never needed at once.
  template <class Sink>
  Status run(uint32_t visits, Sink&& sink) {
    if (error_ != Status::done || state_ == State::done) {
      return status();
    }
    if (state_ == State::fresh) {
      if (visits == 0) {
        return Status::suspended;
      }
      if (Order::kStartsAtRoots && Question::kDisjointRootsEnd &&
          transform_.roots_disjoint(*a_, *b_)) {
        counts_.visits = 1;
        state_ = State::done;
        return Status::done;
      }
      transform_.prepare();
    }
    return go_on(visits, sink);
  }

  /// Where the query stands. Between runs; not for orders with a stack.
  [[nodiscard]] QueryPosition<Index> position() const {
    return {cursor_.a, cursor_.b, untested_, state_};
  }

  /// Goes on from a position of a query on the same meshes and pose; counts go on from what they
  /// are. `position_invalid`, and nothing changes, if no query on these meshes has such a position;
  /// one of another pose is not told apart, and gives the pairs after it.
  Status resume(const QueryPosition<Index>& position) {
    if (error_ != Status::done) {
      return error_;
    }
    if (!is_possible(position)) {
      return Status::position_invalid;
    }
    cursor_ = {position.a, position.b};
    state_ = position.state;
    untested_ = state_ == State::at_leaf_pair ? static_cast<uint16_t>(position.untested) : 0;
    if (state_ == State::fresh) {
      cursor_ = Cursor();
    } else if (state_ != State::done) {
      transform_.prepare();
    }
    return status();
  }

  /// The triangles of the pair reported last, in A's frame: inside a sink, and after a run that
  /// wrote a pair and ended with `full`.
  void last_pair(Triangle& a, Triangle& b) const {
    const Leaves leaves = this->leaves();
    detail::translate_triangle(*a_, leaves.of_a(untested_), detail::kNoOffset, a);
    detail::transform_triangle(*b_, leaves.of_b(untested_), transform_, b);
  }

 private:
  /// The triangles of the cursor's pair of leaves, by position. Their pairs are taken from the last
  /// one on, all of A's for each of B's.
  struct Leaves {
    uint32_t first_a, count_a;
    uint32_t first_b, count_b;

    uint32_t pairs() const { return count_a * count_b; }
    uint32_t of_a(uint32_t pair) const { return first_a + (count_a == 1 ? 0 : pair % count_a); }
    uint32_t of_b(uint32_t pair) const { return first_b + (count_a == 1 ? pair : pair / count_a); }
  };

  Leaves leaves() const { return leaves(Order::nodes(*a_, *b_, cursor_)); }

  Leaves leaves(const detail::PairCursor<Index>& nodes) const {
    const uint32_t leaf_a = a_->nodes[nodes.a].leaf();
    const uint32_t leaf_b = b_->nodes[nodes.b].leaf();
    const uint32_t first_a = a_->first_triangle(leaf_a);
    const uint32_t first_b = b_->first_triangle(leaf_b);
    return {first_a, a_->end_triangle(leaf_a) - first_a, first_b,
            b_->end_triangle(leaf_b) - first_b};
  }

  template <class Sink>
  Status go_on(uint32_t visits, Sink& sink) {
    for (;;) {
      while (untested_ != 0) {
        if (next_triangles_answer() && !sink(current_pair())) {
          return Status::full;
        }
      }
      state_ = walk(visits);
      if (state_ != State::at_leaf_pair) {
        return status();
      }
      ++counts_.leaf_pairs;
      untested_ = static_cast<uint16_t>(leaves().pairs());
    }
  }

  bool is_possible(const QueryPosition<Index>& position) const {
    if (position.state != State::at_pair && position.state != State::at_leaf_pair) {
      return position.state == State::fresh || position.state == State::done;
    }
    const Cursor cursor = {position.a, position.b};
    if (transform_.is_far_apart() || position.a >= a_->node_count || position.b >= b_->node_count ||
        !Order::can_visit(*a_, *b_, cursor)) {
      return false;
    }
    if (position.state == State::at_pair) {
      return true;
    }
    const detail::PairCursor<Index> nodes = Order::nodes(*a_, *b_, cursor);
    return a_->nodes[nodes.a].is_leaf() && b_->nodes[nodes.b].is_leaf() &&
           position.untested <= leaves(nodes).pairs();
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

  /// To the next pair of leaves, the end, or the last visit granted.
  State walk(uint32_t& visits_left) {
    return transform_.is_rotated() ? walk_rotated(visits_left) : walk_translated(visits_left);
  }
  FLASHBVH_NOINLINE State walk_translated(uint32_t& visits_left) {
    return walk_with(Question::translated(transform_.translated()), visits_left);
  }
  FLASHBVH_NOINLINE State walk_rotated(uint32_t& visits_left) {
    auto bound = Question::rotated(transform_.rotated());
    return walk_with(detail::ByReference<decltype(bound)>{&bound}, visits_left);
  }
  template <class Bound>
  State walk_with(const Bound& bound, uint32_t& visits_left) {
    const detail::StopAtLeaves stop;
    const detail::WalkRun<Cursor, detail::StopAtLeaves> run = {&cursor_, &counts_, &visits_left,
                                                               &stop};
    return detail::walk<Order>(*a_, *b_, bound, run, state_ == State::at_leaf_pair);
  }

  /// Tests pairs of triangles of the current leaves until one is an answer or B's next triangle is
  /// due. Rotating B's costs most, so it is transformed once and all of A's are held against it.
  /// Nothing but `this` outlives the call, which keeps the stack flat where it is deepest.
  FLASHBVH_NOINLINE bool next_triangles_answer() {
    Triangle a;
    Triangle b;
    const Leaves leaves = this->leaves();
    --untested_;
    detail::transform_triangle(*b_, leaves.of_b(untested_), transform_, b);
    for (uint32_t of_a = leaves.of_a(untested_);; --of_a, --untested_) {
      detail::translate_triangle(*a_, of_a, detail::kNoOffset, a);
      if (Question::test(a, b)) {
        ++counts_.triangle_pairs;
        return true;
      }
      if (of_a == leaves.first_a) {
        return false;
      }
    }
  }

  Pair current_pair() const {
    const Leaves leaves = this->leaves();
    return {a_->triangle_ids[leaves.of_a(untested_)], b_->triangle_ids[leaves.of_b(untested_)]};
  }

  const Mesh* a_;
  const Mesh* b_;
  detail::Transform transform_;
  Counts counts_;
  Cursor cursor_;
  uint16_t untested_;  ///< pairs of triangles that the cursor's pair of leaves still has
  State state_;
  Status error_;  ///< `done`: none
};

/// The default query, and the same for meshes with 32-bit indices.
using PairQuery = Query<Ranked<PostMesh>>;
using LargePairQuery = Query<Ranked<LargePostMesh>>;

// Compiled once, in the library.
extern template class Query<Ranked<PostMesh>>;
extern template class Query<Ranked<LargePostMesh>>;

}  // namespace flashbvh

#endif
