// Ranked for a tree against itself: each unordered pair of leaves once, and each leaf with itself.
//
// The walk visits a pair (a, b) if a's subtree has a leaf no later in the array than a leaf of b's.
// In a post-indexed tree a node lies before its subtree, disjoint subtrees lie one after the other,
// and siblings are visited by falling index. By the invariant of ranks, b is never a proper
// descendant of a: rank(a) < rank(parent of b), and ranks never grow downwards. So b's later
// siblings matter while b lies after a. The last sibling that matters is a or contains a; the
// siblings after it lie before a. The siblings of a never pass b: if the parent of a were disjoint
// from b, it would lie before b.
#pragma once

#include <stdint.h>

#include "flashbvh/traversal/ranked.hpp"

namespace flashbvh::detail {

template <class TreeType>
class SelfRanked : public Ranked<TreeType> {
  using Base = Ranked<TreeType>;

 public:
  using OfTranslations = SelfRanked;
  using Base::Base;
  using typename Base::Cursor;
  using typename Base::Tree;

  /// As Ranked::can_visit(), but false for pairs that a walk against itself skips.
  static bool can_visit(const Tree& tree, const Tree&, const Cursor& cursor) {
    return Base::can_visit(tree, tree, cursor) &&
           (cursor.a <= cursor.b || holds(tree, cursor.b, cursor.a));
  }

  bool next() {
    for (;;) {
      if (this->b_.parent_rank <= this->a_.parent_rank) {
        if (this->b_.node > this->a_.node && this->b_.next_sibling()) {
          return true;
        }
        if (this->b_.node == this->b_.root) {
          return false;
        }
        this->b_.skip_siblings();
        this->b_.ascend();
      } else {
        if (this->a_.next_sibling()) {
          return true;
        }
        this->a_.ascend();
      }
    }
  }

 private:
  /// True if `node` lies in the subtree below `root`. `root` is the smaller index.
  static bool holds(const Tree& tree, uint32_t root, uint32_t node) {
    while (node > root) {
      while (tree.nodes[node].link < node) {
        node = tree.nodes[node].link;
      }
      --node;  // from a last child to its parent
    }
    return node == root;
  }
};

}  // namespace flashbvh::detail
