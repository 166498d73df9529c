// The tests of the triangles of pairs of leaves, which a walk collects in a batch.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/query/query_setup.hpp"
#include "flashbvh/detail/query/triangle_test.hpp"
#include "flashbvh/detail/walk/leaf_pairs.hpp"

namespace flashbvh::detail {

/// A query's tests of triangles, and their counts.
template <class Traversal, class Predicate>
class LeafTests : protected QuerySetup<Traversal, Predicate> {
  using Base = QuerySetup<Traversal, Predicate>;

 protected:
  using Base::a_, Base::b_, Base::cursor_, Base::leaf_a_, Base::leaf_b_;
  using Base::stats_, Base::transform_, Base::untested_;
  using typename Base::Cursor, typename Base::Index, typename Base::Mesh;
  using Pair = TrianglePair<Index>;
  /// Traversals with a stack can't go back to a pair, so their batch is one pair.
  using Batch =
      LeafPairs<Mesh, Traversal::kStackless ? Predicate::kBatch : 1, Predicate::kPairWork>;

  FLASHBVH_INLINE LeafTests(const Mesh& a, const Mesh& b, const Pose& pose, const Cursor& start,
                            const Predicate& predicate)
      : Base(a, b, pose, start, predicate) {}

  /// Removes the pair last handed to a sink from the counts.
  void uncount_pair() { --stats_.triangle_pairs; }

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

 private:
  using Test = TriangleTest<Predicate, Mesh, Predicate::kIntersects>;

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
};

}  // namespace flashbvh::detail
