// Ranked: stackless, in the order of a dynamic rule.
//
// Every internal node has a rank that never grows from a parent to its child (a quantised size of
// its box); leaves have none. The rule: descend into the node of the larger rank, into A on a tie.
//
// Invariant: on the way from the roots to a pair (a, b) the walk has descended through exactly the
// proper ancestors of a and of b, and, ranks being monotone along each chain, it took them in
// merged order of rank, A's before B's on ties. So the ancestor descended into last is the one of
// smaller rank among parent(a) and parent(b), and B's on a tie: the pair behind (a, b) is a
// function of the pair. A root's missing parent counts as kRootParentRank, above every real rank,
// so a root is left last, and the walk is over when both nodes are roots.
//
// Post-indexed trees only. Each ascent undoes a descent: constant time a visit, amortised.
#ifndef FLASHBVH_TRAVERSAL_RANKED_HPP
#define FLASHBVH_TRAVERSAL_RANKED_HPP

#include <stdint.h>

#include "flashbvh/tree.hpp"
#include "flashbvh/walk.hpp"

namespace flashbvh {

template <class TreeType>
class Ranked {
  using Index = typename TreeType::Index;
  using NodeType = Node<Index>;
  static_assert(TreeType::kLayout == Layout::post_indexed, "ranked walks post-indexed trees");

 public:
  using Tree = TreeType;
  using Cursor = PairCursor<Index>;
  static constexpr bool kStartsAtRoots = true;

  static Cursor nodes(const Tree&, const Tree&, const Cursor& cursor) { return cursor; }
  /// Any pair: what lies behind it is a function of it.
  static bool can_visit(const Tree&, const Tree&, const Cursor&) { return true; }

  template <class Overlap, class LeafPair>
  FLASHBVH_NOINLINE static Walk run(const Tree& a, const Tree& b, const Overlap& overlap,
                                    Cursor& cursor, Budget& budget, const LeafPair& leaf_pair) {
    Outside<Cursor, LeafPair> outside = {&cursor, &budget, &leaf_pair};
    keep_in_memory(outside);
    const Overlap boxes_overlap = overlap;
    Side side_a(a, cursor.a);
    Side side_b(b, cursor.b);
    uint32_t visits_left = budget.visits_left;
    uint32_t overlaps = budget.overlaps;
    Walk end = Walk::done;
    for (bool visit = !budget.behind;; visit = true) {
      if (visit) {
        if (visits_left == 0) {
          end = Walk::suspended;
          break;
        }
        --visits_left;
        if (boxes_overlap(side_a.node->box, side_b.node->box)) {
          ++overlaps;
          const int32_t rank_a = side_a.node->rank();
          const int32_t rank_b = side_b.node->rank();
          if (rank_a < rank_b) {
            if (rank_b > 0) {
              side_b.descend(rank_b);
              continue;
            }
          } else if (rank_a > 0) {
            side_a.descend(rank_a);
            continue;
          }
          if (!(*outside.leaf_pair)(side_a.index(), side_b.index())) {
            end = Walk::stopped;
            break;
          }
        }
      }
      if (!step(side_a, side_b)) {
        break;
      }
    }
    outside.cursor->a = side_a.index();
    outside.cursor->b = side_b.index();
    outside.budget->visits_left = visits_left;
    outside.budget->overlaps = overlaps;
    return end;
  }

 private:
  /// Where the walk is in one of the trees.
  struct Side {
    const NodeType* root;
    const NodeType* node;
    int32_t parent_rank;

    Side(const Tree& tree, Index index)
        : root(tree.nodes), node(tree.nodes + index), parent_rank(find_parent_rank(tree, index)) {}

    Index index() const { return static_cast<Index>(node - root); }

    void descend(int32_t rank) {
      parent_rank = rank;
      node = root + node[1].link;
    }

    /// To the next sibling; false, and nowhere, if there is none. A root has none.
    bool next_sibling() {
      const NodeType* const next = root + node->link;
      if (next < node) {
        node = next;
        return true;
      }
      return false;
    }

    /// From a last child to its parent.
    void ascend() {
      --node;
      parent_rank = node->parent_rank();
    }
  };

  /// To the pair behind this one; false if there is none.
  static bool step(Side& a, Side& b) {
    for (;;) {
      if (b.parent_rank <= a.parent_rank) {
        if (b.next_sibling()) {
          return true;
        }
        if (b.node == b.root) {
          return false;
        }
        b.ascend();
      } else {
        if (a.next_sibling()) {
          return true;
        }
        a.ascend();
      }
    }
  }

  /// Of any node, in as many steps as it has later siblings.
  static int32_t find_parent_rank(const Tree& tree, uint32_t index) {
    if (index == 0) {
      return kRootParentRank;
    }
    while (tree.nodes[index].link < index) {
      index = tree.nodes[index].link;
    }
    return tree.nodes[index - 1].rank();
  }
};

}  // namespace flashbvh

#endif
