// The order of `ranked` with a stack: its oracle.
#pragma once

#include "flashbvh/detail/walk/stack_order.hpp"

namespace flashbvh::test {

/// Descends into the node of larger rank, into A on ties. Leaves have rank 0, inner nodes more.
struct RankRule {
  template <class Tree, class Node>
  static detail::Side into(const Tree&, const Node* a, const Tree&, const Node* b) {
    static_assert(Tree::kLayout == Layout::post_indexed, "ranked-stack: post-indexed trees");
    const int32_t rank_a = a->rank();
    const int32_t rank_b = b->rank();
    if (rank_a >= rank_b) {
      return rank_a > 0 ? detail::Side::a : detail::Side::none;
    }
    return rank_b > 0 ? detail::Side::b : detail::Side::none;
  }
};

template <class Tree>
using RankedStack = detail::StackOrder<Tree, RankRule>;

}  // namespace flashbvh::test
