// The rule of ranked.hpp with a stack: its reference, and its opponent in the benchmark. It is
// tuned as ranked.hpp is: node addresses in registers, pairs of indices on the stack, and the one
// later sibling that a binary node has is pushed without looking for more.
//
// Invariant: as algorithm 2. Post-indexed trees only.
#ifndef FLASHBVH_TRAVERSAL_RANKED_STACK_HPP
#define FLASHBVH_TRAVERSAL_RANKED_STACK_HPP

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/traversal/stack_walk.hpp"

namespace flashbvh {

template <class TreeType>
class RankedStack {
  using Index = typename TreeType::Index;
  using NodeType = Node<Index>;
  using Entry = PairCursor<Index>;
  static_assert(TreeType::kLayout == Layout::post_indexed, "ranked-stack: post-indexed trees");

 public:
  using Tree = TreeType;
  using Cursor = PairStack<Index>;
  static constexpr bool kStartsAtRoots = true;

  /// The pair on top of the stack is kept out of it while the walk runs.
  template <class Overlap, class LeafPair>
  FLASHBVH_NOINLINE static Walk run(const Tree& a, const Tree& b, const Overlap& overlap,
                                    Cursor& cursor, Budget& budget, const LeafPair& leaf_pair) {
    Outside<Cursor, LeafPair> outside = {&cursor, &budget, &leaf_pair};
    keep_in_memory(outside);
    const Overlap boxes_overlap = overlap;
    const NodeType* const root_a = a.nodes;
    const NodeType* const root_b = b.nodes;
    const Entry* const bottom = cursor.entries();
    Entry* top = cursor.top() - 1;
    const NodeType* node_a = root_a + top->a;
    const NodeType* node_b = root_b + top->b;
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
        if (boxes_overlap(node_a->box, node_b->box)) {
          ++overlaps;
          const int32_t rank_a = node_a->rank();
          const int32_t rank_b = node_b->rank();
          if (rank_a >= rank_b) {
            if (rank_a > 0) {
              top = push_siblings<&Entry::a, &Entry::b>(root_a, node_a, node_b - root_b, top);
              continue;
            }
          } else if (rank_b > 0) {
            top = push_siblings<&Entry::b, &Entry::a>(root_b, node_b, node_a - root_a, top);
            continue;
          }
          if (!(*outside.leaf_pair)(static_cast<uint32_t>(node_a - root_a),
                                    static_cast<uint32_t>(node_b - root_b))) {
            end = Walk::stopped;
            break;
          }
        }
      }
      if (top == bottom) {
        break;
      }
      --top;
      node_a = root_a + top->a;
      node_b = root_b + top->b;
    }
    if (end != Walk::done) {
      top->a = static_cast<Index>(node_a - root_a);
      top->b = static_cast<Index>(node_b - root_b);
      ++top;
    }
    outside.cursor->set_top(top);
    outside.budget->visits_left = visits_left;
    outside.budget->overlaps = overlaps;
    return end;
  }

 private:
  /// Goes to the first child of `node` and pushes the others, the last one first. `own` and
  /// `other`: the members of an entry for this tree and for the other one.
  template <Index Entry::*own, Index Entry::*other>
  static Entry* push_siblings(const NodeType* root, const NodeType*& node, ptrdiff_t other_node,
                              Entry* top) {
    const NodeType* const last = node + 1;
    node = root + last->link;
    if (node == last) {
      return top;
    }
    const NodeType* const next = root + node->link;
    if (next != last) {
      return push_many<own, other>(root, next, last, static_cast<Index>(other_node), top);
    }
    top->*own = static_cast<Index>(last - root);
    top->*other = static_cast<Index>(other_node);
    return top + 1;
  }

  template <Index Entry::*own, Index Entry::*other>
  FLASHBVH_NOINLINE static Entry* push_many(const NodeType* root, const NodeType* next,
                                            const NodeType* last, Index other_node, Entry* top) {
    Entry* first = top;
    for (;; next = root + next->link) {
      top->*own = static_cast<Index>(next - root);
      top->*other = other_node;
      ++top;
      if (next == last) {
        break;
      }
    }
    reverse_entries(first, top);
    return top;
  }
};

}  // namespace flashbvh

#endif
