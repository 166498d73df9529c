// Ranked, of a tree against itself: each unordered pair of leaves once, and each leaf with itself.
//
// Pairs (a, b) are walked where a's subtree holds a leaf that lies no later in the array than one
// of b's. In a post-indexed tree a node lies before its subtree, disjoint subtrees lie one after
// the other, and siblings are taken from the last in the array on. By the invariant of ranks b is
// never a proper descendant of a: rank(a) < rank(parent of b), and ranks never grow downwards. So
// b's later siblings matter as long as b lies after a. A sibling at which that ends is a, or holds
// it; those that follow lie before a. A's siblings never pass b: had a's parent been disjoint from
// b, it would have lain before it.
#ifndef FLASHBVH_DETAIL_WALK_SELF_RANKED_HPP
#define FLASHBVH_DETAIL_WALK_SELF_RANKED_HPP

#include <stdint.h>

#include "flashbvh/detail/walk/ranked.hpp"

namespace flashbvh::detail {

template <class TreeType>
class SelfRanked : public Ranked<TreeType> {
  using Base = Ranked<TreeType>;

 public:
  using OfTranslations = SelfRanked;
  using Base::Base;
  using typename Base::Cursor;
  using typename Base::Tree;

  /// As of Ranked: of a pair that no unordered pair of leaves leads to, false.
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
  /// Whether `node` is in the subtree below `root`, which lies before it.
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

#endif
