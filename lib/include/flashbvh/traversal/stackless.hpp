// Algorithm 4, the stackless algorithm, with the extensions of section 8: unbalanced trees of
// different heights, any number of children. The order is that of algorithm 3 (alternating_stack).
//
// Invariant: the pair that lies below (a, b) on algorithm 3's stack is a function of (a, b): of the
// two levels, whether each node is a left child (one with a next sibling, or the root), and the
// right child levels. `next_pair` is that function, case by case as in section 7.1.
//
// Section 8.1: while one node is a leaf the walk of the other's subtree is the leaf algorithm;
// there the levels differ by more than the eight cases know. Going up along last children until
// they are again as far apart as when the leaf was reached leads back to the eight cases.
//
// The walk is over when a node is the imaginary end node, the root's escape index.
#ifndef FLASHBVH_TRAVERSAL_STACKLESS_HPP
#define FLASHBVH_TRAVERSAL_STACKLESS_HPP

#include <stdint.h>

#include "flashbvh/levels.hpp"
#include "flashbvh/walk.hpp"

namespace flashbvh {

template <class LevelledTree>
class AlternatingStackless {
  using Index = typename LevelledTree::Index;

 public:
  using Tree = LevelledTree;
  using Cursor = PairCursor<Index>;

  template <class Overlap, class LeafPair>
  static Walk run(const Tree& a, const Tree& b, const Overlap& overlap, Cursor& cursor,
                  Budget& budget, LeafPair&& leaf_pair) {
    uint32_t node_a = cursor.a;
    uint32_t node_b = cursor.b;
    uint32_t visits_left = budget.visits_left;
    uint32_t overlaps = budget.overlaps;
    Walk end = Walk::done;
    if (budget.behind) {
      next_pair(a, b, node_a, node_b);
    }
    while (node_a != a.node_count && node_b != b.node_count) {
      if (visits_left == 0) {
        end = Walk::suspended;
        break;
      }
      --visits_left;
      if (overlap(a.nodes[node_a].box, b.nodes[node_b].box)) {
        ++overlaps;
        const bool leaf_a = a.nodes[node_a].is_leaf();
        const bool leaf_b = b.nodes[node_b].is_leaf();
        if (!leaf_a && (leaf_b || a.level(node_a) < b.level(node_b))) {
          node_a = a.first_child(node_a);
          continue;
        }
        if (!leaf_b) {
          node_b = b.first_child(node_b);
          continue;
        }
        if (!leaf_pair(node_a, node_b)) {
          end = Walk::stopped;
          break;
        }
      }
      next_pair(a, b, node_a, node_b);
    }
    cursor.a = static_cast<Index>(node_a);
    cursor.b = static_cast<Index>(node_b);
    budget.visits_left = visits_left;
    budget.overlaps = overlaps;
    return end;
  }

  /// The pair behind (node_a, node_b): the element below it on algorithm 3's stack.
  static void next_pair(const Tree& a, const Tree& b, uint32_t& node_a, uint32_t& node_b) {
    const uint32_t level_a = a.level(node_a);
    const uint32_t level_b = b.level(node_b);
    if (level_a >= level_b) {
      behind_a(a, b, node_a, node_b, level_a - level_b);
    } else {
      behind_b(a, b, node_a, node_b, level_b - level_a);
    }
  }

 private:
  /// Level(a) = Level(b) + `lead`: A was descended into last. `lead` is 0 outside B's leaves.
  static void behind_a(const Tree& a, const Tree& b, uint32_t& node_a, uint32_t& node_b,
                       uint32_t lead) {
    const uint32_t rcl_a = a.rcl(node_a);
    if (rcl_a <= lead) {  // cases 1 and 2; 8.1: the leaf algorithm in A's subtree
      node_a = a.escape(node_a);
      return;
    }
    const uint32_t rcl_b = b.rcl(node_b);
    if (rcl_a - lead <= rcl_b) {  // case 7, a left child of A is reached first
      node_a = a.escape(node_a);
      node_b = b.level_up(node_b, rcl_a - lead);
    } else {  // case 5 (rcl_b = 0); case 7, a left child of B is reached first
      node_a = a.level_up(node_a, lead + rcl_b + 1);
      node_b = b.escape(node_b);
    }
  }

  /// Level(a) = Level(b) - `lead`: B was descended into last. `lead` is 1 outside A's leaves.
  static void behind_b(const Tree& a, const Tree& b, uint32_t& node_a, uint32_t& node_b,
                       uint32_t lead) {
    const uint32_t rcl_b = b.rcl(node_b);
    if (rcl_b < lead) {  // cases 3 and 4; 8.1: the leaf algorithm in B's subtree
      node_b = b.escape(node_b);
      return;
    }
    const uint32_t rcl_a = a.rcl(node_a);
    if (rcl_a <= rcl_b - lead) {  // case 6 (rcl_a = 0); case 8, a left child of A is reached first
      node_a = a.escape(node_a);
      node_b = b.level_up(node_b, rcl_a + lead);
    } else {  // case 8, a left child of B is reached first
      node_a = a.level_up(node_a, rcl_b - lead + 1);
      node_b = b.escape(node_b);
    }
  }
};

/// On pre-indexed trees; LevelUp climbs from parent to parent.
using Stackless = AlternatingStackless<LevelledPreTree>;
using LargeStackless = AlternatingStackless<LargeLevelledPreTree>;

}  // namespace flashbvh

#endif
