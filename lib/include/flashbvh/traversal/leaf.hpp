// Algorithm 1, the leaf algorithm: each leaf of A against the whole of B.
//
// Invariant: the leaves of A before `a` are done; for leaf `a`, so is what lies before `b` in B's
// order from left to right.
// Either layout. The escape index of a post-indexed last child is found by climbing.
#ifndef FLASHBVH_TRAVERSAL_LEAF_HPP
#define FLASHBVH_TRAVERSAL_LEAF_HPP

#include <stdint.h>

#include "flashbvh/tree.hpp"
#include "flashbvh/walk.hpp"

namespace flashbvh {

template <class TreeType>
class Leaf {
  using Index = typename TreeType::Index;
  static constexpr bool kPost = TreeType::kLayout == Layout::post_indexed;

 public:
  using Tree = TreeType;
  /// `a`: how many of A's nodes are passed, from left to right; `b`: the node of B.
  using Cursor = PairCursor<Index>;
  static constexpr bool kStartsAtRoots = false;

  static Cursor nodes(const Tree& a, const Tree&, const Cursor& cursor) {
    return {static_cast<Index>(left_to_right(a, cursor.a)), cursor.b};
  }
  static bool can_visit(const Tree& a, const Tree& b, const Cursor& cursor) {
    return a.nodes[nodes(a, b, cursor).a].is_leaf();
  }

  template <class Overlap, class LeafPair>
  static Walk run(const Tree& a, const Tree& b, const Overlap& overlap, Cursor& cursor,
                  Budget& budget, const LeafPair& leaf_pair) {
    uint32_t passed = cursor.a;
    uint32_t node_b = cursor.b;
    bool behind = budget.behind;
    for (; passed < a.node_count; ++passed, node_b = 0) {
      const uint32_t leaf_a = left_to_right(a, passed);
      if (!a.nodes[leaf_a].is_leaf()) {
        continue;
      }
      const Walk end =
          against_b(a.nodes[leaf_a], leaf_a, b, overlap, node_b, behind, budget, leaf_pair);
      behind = false;
      if (end != Walk::done) {
        cursor.a = static_cast<Index>(passed);
        cursor.b = static_cast<Index>(node_b);
        return end;
      }
    }
    return Walk::done;
  }

 private:
  /// Array order is left to right in a pre-indexed tree, right to left in a post-indexed one.
  static uint32_t left_to_right(const Tree& tree, uint32_t passed) {
    return kPost ? tree.node_count - 1 - passed : passed;
  }

  static uint32_t escape(const Tree& tree, uint32_t node) {
    if (kPost) {
      while (node != 0 && tree.nodes[node].link >= node) {
        --node;
      }
    }
    return tree.nodes[node].link;
  }

  template <class Overlap, class LeafPair>
  static Walk against_b(const Node<Index>& leaf, uint32_t leaf_a, const Tree& b,
                        const Overlap& overlap, uint32_t& node_b, bool behind, Budget& budget,
                        const LeafPair& leaf_pair) {
    if (behind) {
      node_b = escape(b, node_b);
    }
    while (node_b != b.node_count) {
      if (budget.visits_left == 0) {
        return Walk::suspended;
      }
      --budget.visits_left;
      if (overlap(leaf.box, b.nodes[node_b].box)) {
        ++budget.overlaps;
        if (!b.nodes[node_b].is_leaf()) {
          node_b = b.first_child(node_b);
          continue;
        }
        if (!leaf_pair(leaf_a, node_b)) {
          return Walk::stopped;
        }
      }
      node_b = escape(b, node_b);
    }
    return Walk::done;
  }
};

}  // namespace flashbvh

#endif
