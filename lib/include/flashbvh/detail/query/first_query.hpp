// A search for any one pair of triangles that intersect.
//
// A walk spends itself on one part of surfaces that are near each other everywhere, as those of
// nested meshes. So if it takes long, the search looks at the nearest pairs of nodes, wherever they
// lie, before the walk goes on.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/predicates/triangle.hpp"
#include "flashbvh/detail/query/query_run.hpp"
#include "flashbvh/detail/walk/near_first.hpp"
#include "flashbvh/detail/walk/nearest_pairs.hpp"

namespace flashbvh::detail {

template <class Index>
class FirstQuery : QueryRun<NearFirst<BasicMesh<Index, Layout::post_indexed>>, Intersection> {
  using Base = QueryRun<NearFirst<BasicMesh<Index, Layout::post_indexed>>, Intersection>;
  using Base::a_, Base::b_, Base::leaf_a_, Base::leaf_b_, Base::untested_;
  using Base::stats_, Base::transform_;
  using typename Base::Mesh, typename Base::Cursor;
  using Nearest = NearestPairs<Index>;
  using Pair = typename Nearest::Pair;

 public:
  FLASHBVH_INLINE_TO_RUN FirstQuery(const Mesh& a, const Mesh& b, const Pose& pose,
                                    const Cursor& start = Cursor())
      : Base(a, b, pose, start, Intersection()) {}
  using Base::status;

  /// Calls `take(pair)` and returns `full` if there is a pair. `expects_one`: a long walk is worth
  /// a look at the nearest pairs.
  template <class Take>
  FLASHBVH_INLINE Status find(bool expects_one, const Take& take) {
    const auto sink = [&take](const TrianglePair<Index>& pair) {
      take(pair);
      return false;
    };
    const Long& long_walk = transform_.is_rotated() ? kRotated : kTranslated;
    for (uint32_t budget = expects_one ? long_walk.work : kUnlimited;;) {
      uint32_t work = budget;
      const Status end = this->run_with(work, sink, [] { return UINT32_MAX; });
      if (end != Status::suspended) {
        return end;
      }
      const bool is_long = stats_.visits >= long_walk.visits;
      if (is_long && find_nearest()) {
        take(this->current_pair());
        return Status::full;
      }
      budget = is_long ? kUnlimited : 2 * budget;
    }
  }
  /// The slots of the triangles found.
  template <class Slots>
  [[nodiscard]] Slots found_slots() const {
    return {static_cast<Index>(this->of_a(untested_)), static_cast<Index>(this->of_b(untested_))};
  }
  /// True if these triangles, by their slots, intersect; false after an error.
  FLASHBVH_NOINLINE bool holds(uint32_t of_a, uint32_t of_b) const {
    if (this->error() != Status::done || transform_.roots_disjoint()) {
      return false;
    }
    Triangle a;
    Triangle b;
    translate_triangle(*a_, of_a, kNoOffset, a);
    transform_triangle(*b_, of_b, transform_, b);
    return triangles_intersect(a, b);
  }

 private:
  /// A walk of at least this work is long if it has made this many visits: work on triangles soon
  /// finds a pair, if there is one.
  struct Long {
    uint32_t work;
    uint32_t visits;
  };
  static constexpr Long kTranslated = {1000, 400};
  static constexpr Long kRotated = {400, 110};
  /// The most pairs of nodes that are looked at, and of leaves among them.
  static constexpr uint32_t kMostPairs = 150;
  static constexpr uint32_t kMostLeaves = 8;

  /// True if one of the nearest pairs of leaves has a pair, which is then the current one. If not,
  /// the walk can go on. Inlined: its stack is then that of the walk's batch.
  FLASHBVH_INLINE bool find_nearest() {
    const Index leaf_a = leaf_a_;
    const Index leaf_b = leaf_b_;
    const uint16_t untested = untested_;
    Nearest nearest;
    uint32_t leaves = kMostLeaves;
    for (uint32_t left = kMostPairs; left != 0 && leaves != 0 && !nearest.is_empty(); --left) {
      const Pair at = nearest.take();
      if (a_->nodes[at.nodes[0]].is_leaf() && b_->nodes[at.nodes[1]].is_leaf()) {
        if (test(at)) {
          return true;
        }
        --leaves;
      } else {
        open(nearest, at);
      }
    }
    leaf_a_ = leaf_a;
    leaf_b_ = leaf_b;
    untested_ = untested;
    return false;
  }
  /// Adds the pairs below the node of larger rank, as a walk descends.
  FLASHBVH_NOINLINE void open(Nearest& nearest, const Pair& at) const {
    const auto& node_a = a_->nodes[at.nodes[0]];
    const auto& node_b = b_->nodes[at.nodes[1]];
    const bool into_b = node_a.rank() < node_b.rank();
    const PackedTriple window = into_b ? transform_.window_of(Side::a, node_a.box)
                                       : transform_.window_of(Side::b, node_b.box);
    nearest.open(at, into_b ? 1 : 0, into_b ? b_->nodes : a_->nodes, window);
  }
  /// Tests the triangles of two leaves.
  FLASHBVH_NOINLINE bool test(const Pair& at) {
    typename Base::Batch batch(*a_, *b_);
    Progress unlimited{kUnlimited};
    batch.clear(unlimited, 1, false);
    (void)batch(at.nodes[0], at.nodes[1], unlimited);
    untested_ = 0;
    return this->next_answer(batch, 0);
  }
};

}  // namespace flashbvh::detail
