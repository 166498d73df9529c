// A collision query between two baked meshes: which triangles of A meet which triangles of B.
//
// The query object is all the memory there is. It may be stopped after any number of visits and
// gives the same pairs in the same order however it is cut into runs. It writes nothing but itself
// and the caller's array, so any number of queries may share the trees.
#ifndef FLASHBVH_QUERY_HPP
#define FLASHBVH_QUERY_HPP

#include <stdint.h>

#include "flashbvh/box.hpp"
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

/// `Traversal`: Ranked<PostTree> or any other of traversal/. The trees outlive the query.
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
      : Query(a, b, pose, start, Offset(a, b, pose)) {}

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
  template <class Sink>
  Status run(uint32_t visits, Sink&& sink) {
    if (status_ != Status::suspended) {
      return status_;
    }
    if (at_leaf_pair_ && !test_leaf_pair(sink)) {
      return Status::full;
    }
    Budget budget = {visits, counts_.overlaps, at_leaf_pair_};
    const Walk end =
        Traversal::run(*a_, *b_, overlap_, cursor_, budget, [&](uint32_t i, uint32_t j) {
          leaf_a_ = a_->nodes[i].leaf();
          leaf_b_ = b_->nodes[j].leaf();
          tested_ = 0;
          ++counts_.leaf_pairs;
          return test_leaf_pair(sink);
        });
    counts_.visits += visits - budget.visits_left;
    counts_.overlaps = budget.overlaps;
    at_leaf_pair_ = end == Walk::stopped;
    if (end == Walk::done) {
      status_ = Status::done;
    }
    return at_leaf_pair_ ? Status::full : status_;
  }

 private:
  /// From B's lattice to A's: both count from their own origins.
  struct Offset {
    int32_t x, y, z;
    Offset(const Tree& a, const Tree& b, const Pose& pose)
        : x(axis(a, b, pose, 0)), y(axis(a, b, pose, 1)), z(axis(a, b, pose, 2)) {}
    /// Wraps if the pose is out of range, which check() refuses.
    static int32_t axis(const Tree& a, const Tree& b, const Pose& pose, int i) {
      return static_cast<int32_t>(static_cast<uint32_t>(pose.translation[i]) +
                                  static_cast<uint32_t>(b.origin[i]) -
                                  static_cast<uint32_t>(a.origin[i]));
    }
  };

  Query(const Tree& a, const Tree& b, const Pose& pose, const Cursor& start, const Offset& offset)
      : a_(&a),
        b_(&b),
        overlap_(offset.x, offset.y, offset.z),
        offset_{offset.x, offset.y, offset.z},
        counts_{0, 0, 0, 0},
        cursor_(start),
        tested_(0),
        leaf_a_(0),
        leaf_b_(0),
        at_leaf_pair_(false),
        status_(check(a, b, pose, start)) {}

  static Status check(const Tree& a, const Tree& b, const Pose& pose, const Cursor& start) {
    if (a.cell_bits != b.cell_bits) {
      return Status::cell_mismatch;
    }
    if (!pose.is_translation()) {
      return Status::rotation_unsupported;
    }
    for (const int32_t t : pose.translation) {
      if (t < -kMaxTranslation || t > kMaxTranslation) {
        return Status::translation_out_of_range;
      }
    }
    return fits(start, a, b) ? Status::suspended : Status::stack_too_small;
  }

  static bool fits(const PairCursor<Index>&, const Tree&, const Tree&) { return true; }
  static bool fits(const PairStack<Index>& stack, const Tree& a, const Tree& b) {
    return stack.capacity() >= stack_entries(a.stack_need, b.stack_need);
  }

  /// Goes on with the leaf pair behind the `tested_` first triangle pairs; false if the sink stops.
  template <class Sink>
  bool test_leaf_pair(Sink& sink) {
    const uint32_t first_a = a_->first_triangle(leaf_a_);
    const uint32_t first_b = b_->first_triangle(leaf_b_);
    const uint32_t count_b = b_->end_triangle(leaf_b_) - first_b;
    const uint32_t count = (a_->end_triangle(leaf_a_) - first_a) * count_b;
    while (tested_ < count) {
      const uint32_t i = first_a + tested_ / count_b;
      const uint32_t j = first_b + tested_ % count_b;
      ++tested_;
      if (triangles_intersect(place(*a_, i, 0, 0, 0),
                              place(*b_, j, offset_.x, offset_.y, offset_.z))) {
        ++counts_.triangle_pairs;
        if (!sink(Pair{a_->sources[i], b_->sources[j]})) {
          return false;
        }
      }
    }
    return true;
  }

  static PlacedTriangle place(const Tree& tree, uint32_t triangle, int32_t x, int32_t y,
                              int32_t z) {
    PlacedTriangle placed;
    for (int i = 0; i < 3; ++i) {
      const Vertex& v = tree.vertices[tree.triangles[triangle].corner[i]];
      placed.corner[i] = {v.x + x, v.y + y, v.z + z};
    }
    return placed;
  }

  const Tree* a_;
  const Tree* b_;
  TranslatedOverlap overlap_;
  Point offset_;
  Counts counts_;
  Cursor cursor_;
  uint32_t tested_;  ///< triangle pairs of the current leaf pair that are done
  Index leaf_a_;     ///< the current pair of leaves, by number
  Index leaf_b_;
  bool at_leaf_pair_;  ///< the cursor is at the current pair of leaves, which was visited
  Status status_;
};

/// The default query.
using PairQuery = Query<Ranked<PostTree>>;

}  // namespace flashbvh

#endif
