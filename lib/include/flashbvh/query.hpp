// A collision query between two baked meshes: which triangles of A meet which triangles of B.
//
// The query object is all the memory there is. It may be stopped after any number of visits and
// gives the same pairs in the same order however it is cut into runs. It writes nothing but itself
// and the caller's array, so any number of queries may share the trees.
#ifndef FLASHBVH_QUERY_HPP
#define FLASHBVH_QUERY_HPP

#include <stdint.h>

#include "flashbvh/box.hpp"
#include "flashbvh/box_rotated.hpp"
#include "flashbvh/placement.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/status.hpp"
#include "flashbvh/traversal/ranked.hpp"
#include "flashbvh/traversal/stack_walk.hpp"
#include "flashbvh/tree.hpp"
#include "flashbvh/triangle.hpp"
#include "flashbvh/walk.hpp"

namespace flashbvh {

/// The columns of the paper's tables.
struct Counts {
  uint32_t visits;          ///< pairs of boxes tested ("iterations")
  uint32_t overlaps;        ///< of these, pairs that overlap
  uint32_t leaf_pairs;      ///< of these, pairs of leaves ("leaf overlaps")
  uint32_t triangle_pairs;  ///< pairs of triangles that intersect ("geometry overlaps")
};

/// Two triangles that intersect, by their numbers in the source meshes.
template <class Index>
struct TrianglePair {
  Index a;
  Index b;
};

/// What a run gave.
struct Step {
  Status status;
  uint32_t count;  ///< entries written to the caller's array
};

/// Where a stackless query stands, between runs: all there is to keep of it beside what it was made
/// of, its trees and its pose. May be stored for as long as one likes, as bytes too: 12 of them
/// with 16-bit indices.
template <class IndexType>
struct QueryPosition {
  enum class State : uint8_t {
    fresh = 0,         ///< no visit was made
    at_pair = 1,       ///< the pair of nodes is to be visited next
    at_leaf_pair = 2,  ///< it was visited: a pair of leaves, of whose triangles some are untested
    done = 3,
  };

  IndexType a = 0;
  IndexType b = 0;
  uint32_t untested = 0;  ///< pairs of triangles that the pair of leaves still has
  State state = State::fresh;
};

/// `Traversal`: Ranked<PostTree> or any other of traversal/. The trees and the pose outlive the
/// query.
template <class Traversal>
class Query {
 public:
  using Tree = typename Traversal::Tree;
  using Index = typename Tree::Index;
  using Cursor = typename Traversal::Cursor;
  using Pair = TrianglePair<Index>;

  /// B lies at `pose` in A's frame. Stack traversals take their array as `start`; the stackless
  /// ones need nothing. Errors show in status() and in every run.
  Query(const Tree& a, const Tree& b, const Pose& pose, const Cursor& start = Cursor())
      : a_(&a),
        b_(&b),
        placement_(pose, a, b, Traversal::kStartsAtRoots),
        counts_{0, 0, 0, 0},
        cursor_(start),
        untested_(0),
        leaf_a_(0),
        leaf_b_(0),
        at_leaf_pair_(false),
        started_(false),
        status_(check(a, b, pose, start)) {}

  /// A pose that would be gone before the first run.
  Query(const Tree& a, const Tree& b, const Pose&& pose, const Cursor& start = Cursor()) = delete;

  /// `suspended` while there is something left to do.
  Status status() const { return status_; }
  const Counts& counts() const { return counts_; }

  /// Makes at most `visits` visits and writes at most `capacity` pairs to `found`.
  /// Returns `done`; `suspended` after the last visit granted; `full` as soon as the array is; or
  /// an error. Behind `suspended` and `full` the next run goes on where this one ended.
  Step run(uint32_t visits, Pair* found, uint32_t capacity) {
    uint32_t count = 0;
    if (capacity == 0 && status_ == Status::suspended) {
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

  /// Hands each pair to `sink(pair)`; if that returns false, the run ends with `full` behind it.
  ///
  /// The walk comes back at each pair of leaves, so that its stack and that of the triangle test
  /// are never needed at once.
  template <class Sink>
  Status run(uint32_t visits, Sink&& sink) {
    if (status_ != Status::suspended) {
      return status_;
    }
    if (!started_) {
      if (visits == 0) {
        return Status::suspended;
      }
      if (Traversal::kStartsAtRoots && placement_.roots_apart(*a_, *b_)) {
        counts_.visits = 1;
        status_ = Status::done;
        return status_;
      }
      start();
    }
    return go_on(visits, sink);
  }

  /// Where the query stands. Between runs; not for stack traversals.
  QueryPosition<Index> position() const {
    using State = typename QueryPosition<Index>::State;
    const State state = status_ == Status::done ? State::done
                        : at_leaf_pair_         ? State::at_leaf_pair
                        : started_              ? State::at_pair
                                                : State::fresh;
    return {cursor_.a, cursor_.b, untested_, state};
  }

  /// Goes on from a position of a query on the same trees and pose; counts go on from what they
  /// are. `position_invalid`, and nothing changes, if no query on these trees has such a position;
  /// one of another pose is not told apart, and gives the pairs behind it.
  Status resume(const QueryPosition<Index>& position) {
    using State = typename QueryPosition<Index>::State;
    if (status_ != Status::suspended && status_ != Status::done) {
      return status_;
    }
    if (!is_possible(position)) {
      return Status::position_invalid;
    }
    cursor_.a = position.a;
    cursor_.b = position.b;
    at_leaf_pair_ = position.state == State::at_leaf_pair;
    untested_ = at_leaf_pair_ ? position.untested : 0;
    if (at_leaf_pair_) {
      set_leaves(Traversal::nodes(*a_, *b_, cursor_));
    }
    if (position.state == State::at_pair || at_leaf_pair_) {
      start();
    } else {
      started_ = false;
    }
    status_ = position.state == State::done ? Status::done : Status::suspended;
    return status_;
  }

  /// The triangles of the pair reported last, placed in A's frame: inside a sink, and after a run
  /// that wrote a pair and ended with `full`.
  void last_pair(PlacedTriangle& a, PlacedTriangle& b) const {
    place_translated(*a_, current_a(), kNoOffset, a);
    place_b(current_b(), b);
  }

 private:
  template <class Sink>
  Status go_on(uint32_t visits, Sink& sink) {
    counts_.visits += visits;
    for (;;) {
      while (untested_ != 0) {
        if (next_triangles_intersect() && !sink(current_pair())) {
          counts_.visits -= visits;
          return Status::full;
        }
      }
      const Walk end = walk(visits);
      if (end != Walk::stopped) {
        counts_.visits -= visits;
        status_ = end == Walk::done ? Status::done : Status::suspended;
        return status_;
      }
    }
  }

  void start() {
    placement_.prepare();
    started_ = true;
  }

  bool is_possible(const QueryPosition<Index>& position) const {
    using State = typename QueryPosition<Index>::State;
    if (position.state > State::done || placement_.is_far_apart()) {
      return position.state == State::fresh || position.state == State::done;
    }
    const Cursor cursor = {position.a, position.b};
    if (position.a >= a_->node_count || position.b >= b_->node_count) {
      return false;
    }
    if (position.state != State::at_leaf_pair) {
      return position.state != State::at_pair || Traversal::can_visit(*a_, *b_, cursor);
    }
    const PairCursor<Index> nodes = Traversal::nodes(*a_, *b_, cursor);
    return Traversal::can_visit(*a_, *b_, cursor) && a_->nodes[nodes.a].is_leaf() &&
           b_->nodes[nodes.b].is_leaf() &&
           position.untested <= triangles(*a_, a_->nodes[nodes.a].leaf()) *
                                    triangles(*b_, b_->nodes[nodes.b].leaf());
  }

  static Status check(const Tree& a, const Tree& b, const Pose& pose, const Cursor& start) {
    if (a.cell_bits != b.cell_bits) {
      return Status::cell_mismatch;
    }
    if (pose.status() != Status::done) {
      return pose.status();
    }
    return fits(start, a, b) ? Status::suspended : Status::stack_too_small;
  }

  static bool fits(const PairCursor<Index>&, const Tree&, const Tree&) { return true; }
  static bool fits(const PairStack<Index>& stack, const Tree& a, const Tree& b) {
    return stack.capacity() >= stack_entries(a.stack_need, b.stack_need);
  }

  /// To the next pair of leaves, the end, or the last visit granted.
  Walk walk(uint32_t& visits_left) {
    return placement_.is_rotated() ? walk_rotated(visits_left) : walk_translated(visits_left);
  }
  FLASHBVH_NOINLINE Walk walk_translated(uint32_t& visits_left) {
    return walk_with(placement_.translated().overlap, visits_left);
  }
  FLASHBVH_NOINLINE Walk walk_rotated(uint32_t& visits_left) {
    RotatedOverlap test(placement_.rotated());
    return walk_with(RotatedTest{&test}, visits_left);
  }

  template <class Overlap>
  Walk walk_with(const Overlap& overlap, uint32_t& visits_left) {
    Budget budget = {visits_left, counts_.overlaps, at_leaf_pair_};
    const Walk end = Traversal::run(
        *a_, *b_, overlap, cursor_, budget, [this](uint32_t node_a, uint32_t node_b) {
          set_leaves({static_cast<Index>(node_a), static_cast<Index>(node_b)});
          return false;
        });
    visits_left = budget.visits_left;
    counts_.overlaps = budget.overlaps;
    at_leaf_pair_ = end == Walk::stopped;
    if (at_leaf_pair_) {
      ++counts_.leaf_pairs;
      untested_ = triangles_of_a() * triangles_of_b();
    }
    return end;
  }

  /// Tests pairs of triangles of the current leaves until one meets or B's next triangle is due.
  /// Turning B's costs most, so it is placed once and all of A's are held against it. Nothing but
  /// `this` outlives the call, which keeps the stack flat where it is deepest.
  FLASHBVH_NOINLINE bool next_triangles_intersect() {
    PlacedTriangle a;
    PlacedTriangle b;
    --untested_;
    place_b(current_b(), b);
    for (uint32_t of_a = current_a();; --of_a, --untested_) {
      place_translated(*a_, of_a, kNoOffset, a);
      if (triangles_intersect(a, b)) {
        ++counts_.triangle_pairs;
        return true;
      }
      if (of_a == a_->first_triangle(leaf_a_)) {
        return false;
      }
    }
  }

  FLASHBVH_NOINLINE void place_b(uint32_t triangle, PlacedTriangle& b) const {
    if (placement_.is_rotated()) {
      place_rotated(*b_, triangle, placement_.rotated(), b);
    } else {
      place_translated(*b_, triangle, placement_.translated().offset, b);
    }
  }

  void set_leaves(const PairCursor<Index>& nodes) {
    leaf_a_ = a_->nodes[nodes.a].leaf();
    leaf_b_ = b_->nodes[nodes.b].leaf();
  }

  /// Positions of the current pair of triangles: the leaves' pairs are taken from the last one on.
  uint32_t current_a() const { return a_->first_triangle(leaf_a_) + untested_ % triangles_of_a(); }
  uint32_t current_b() const { return b_->first_triangle(leaf_b_) + untested_ / triangles_of_a(); }
  Pair current_pair() const { return {a_->sources[current_a()], b_->sources[current_b()]}; }

  static uint32_t triangles(const Tree& tree, uint32_t leaf) {
    return tree.end_triangle(leaf) - tree.first_triangle(leaf);
  }
  uint32_t triangles_of_a() const { return triangles(*a_, leaf_a_); }
  uint32_t triangles_of_b() const { return triangles(*b_, leaf_b_); }

  const Tree* a_;
  const Tree* b_;
  Placement placement_;
  Counts counts_;
  Cursor cursor_;
  uint32_t untested_;  ///< pairs of triangles that the current pair of leaves still has
  Index leaf_a_;       ///< the current pair of leaves, by number
  Index leaf_b_;
  bool at_leaf_pair_;  ///< the cursor is at the current pair of leaves, which was visited
  bool started_;       ///< the walk's first visit may have been made
  Status status_;
};

/// The default query.
using PairQuery = Query<Ranked<PostTree>>;

}  // namespace flashbvh

#endif
