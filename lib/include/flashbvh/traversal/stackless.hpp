// Algorithm 4, the stackless algorithm, with the extensions of section 8: unbalanced trees of
// different heights, any number of children. The order is that of algorithm 3 (alternating_stack).
//
// Invariant: the pair that lies below (a, b) on algorithm 3's stack is a function of (a, b): of the
// two levels, whether each node is a left child (one with a next sibling, or the root), and the
// right child levels. `behind` is that function, case by case as in section 7.1.
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
  static constexpr bool kStartsAtRoots = true;

  static Cursor nodes(const Tree&, const Tree&, const Cursor& cursor) { return cursor; }
  /// Levels are further apart than the alternating rule makes them only under a leaf.
  static bool can_visit(const Tree& a, const Tree& b, const Cursor& cursor) {
    const uint32_t level_a = a.level(cursor.a);
    const uint32_t level_b = b.level(cursor.b);
    return level_a > level_b ? b.nodes[cursor.b].is_leaf()
                             : level_b - level_a <= 1 || a.nodes[cursor.a].is_leaf();
  }

  template <class Overlap, class LeafPair>
  FLASHBVH_NOINLINE static Walk run(const Tree& a, const Tree& b, const Overlap& overlap,
                                    Cursor& cursor, Budget& budget, const LeafPair& leaf_pair) {
    Outside<Cursor, LeafPair> outside = {&cursor, &budget, &leaf_pair};
    keep_in_memory(outside);
    const Overlap boxes_overlap = overlap;
    Place at = {cursor.a, cursor.b, 0};
    at.lead = static_cast<int32_t>(a.level(at.a)) - static_cast<int32_t>(b.level(at.b));
    const Node<Index>* const nodes_a = a.nodes;
    const Node<Index>* const nodes_b = b.nodes;
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
        const Node<Index>& node_a = nodes_a[at.a];
        const Node<Index>& node_b = nodes_b[at.b];
        if (boxes_overlap(node_a.box, node_b.box)) {
          ++overlaps;
          const bool leaf_b = node_b.is_leaf();
          if ((at.lead < 0 || leaf_b) && !node_a.is_leaf()) {
            at.a = a.first_child(at.a);
            ++at.lead;
            continue;
          }
          if (!leaf_b) {
            at.b = b.first_child(at.b);
            --at.lead;
            continue;
          }
          if (!(*outside.leaf_pair)(at.a, at.b)) {
            end = Walk::stopped;
            break;
          }
        }
      }
      if (!behind(a, b, at)) {
        break;
      }
    }
    outside.cursor->a = static_cast<Index>(at.a);
    outside.cursor->b = static_cast<Index>(at.b);
    outside.budget->visits_left = visits_left;
    outside.budget->overlaps = overlaps;
    return end;
  }

  /// A pair, and Level(a) - Level(b), which follows from it.
  struct Place {
    uint32_t a;
    uint32_t b;
    int32_t lead;
  };

  /// To the pair behind this one: the element below it on algorithm 3's stack. False if there is
  /// none: then a node is its tree's end node.
  static bool behind(const Tree& a, const Tree& b, Place& at) {
    return at.lead >= 0 ? behind_a(a, b, at) : behind_b(a, b, at);
  }

 private:
  /// Level(a) = Level(b) + lead: A was descended into last. The lead is 0 outside B's leaves.
  static bool behind_a(const Tree& a, const Tree& b, Place& at) {
    const auto lead = static_cast<uint32_t>(at.lead);
    const uint32_t rcl_a = a.rcl(at.a);
    if (rcl_a <= lead) {  // cases 1 and 2; 8.1: the leaf algorithm in A's subtree
      at.lead -= static_cast<int32_t>(rcl_a);
      return escape_a(a, at, rcl_a);
    }
    const uint32_t rcl_b = b.rcl(at.b);
    if (rcl_a - lead <= rcl_b) {  // case 7, a left child of A is reached first
      at.b = b.level_up(at.b, rcl_a - lead);
      at.lead = 0;
      return escape_a(a, at, rcl_a);
    }  // case 5 (rcl_b = 0); case 7, a left child of B is reached first
    at.a = a.level_up(at.a, lead + rcl_b + 1);
    at.lead = -1;
    return escape_b(b, at, rcl_b);
  }

  /// Level(a) = Level(b) - lag: B was descended into last. The lag is 1 outside A's leaves.
  static bool behind_b(const Tree& a, const Tree& b, Place& at) {
    const auto lag = static_cast<uint32_t>(-at.lead);
    const uint32_t rcl_b = b.rcl(at.b);
    if (rcl_b < lag) {  // cases 3 and 4; 8.1: the leaf algorithm in B's subtree
      at.lead += static_cast<int32_t>(rcl_b);
      return escape_b(b, at, rcl_b);
    }
    const uint32_t rcl_a = a.rcl(at.a);
    if (rcl_a <= rcl_b - lag) {  // case 6 (rcl_a = 0); case 8, a left child of A is reached first
      at.b = b.level_up(at.b, rcl_a + lag);
      at.lead = 0;
      return escape_a(a, at, rcl_a);
    }  // case 8, a left child of B is reached first
    at.a = a.level_up(at.a, rcl_b - lag + 1);
    at.lead = -1;
    return escape_b(b, at, rcl_b);
  }

  static bool escape_a(const Tree& a, Place& at, uint32_t rcl_a) {
    at.a = a.escape(at.a, rcl_a);
    return at.a != a.node_count;
  }
  static bool escape_b(const Tree& b, Place& at, uint32_t rcl_b) {
    at.b = b.escape(at.b, rcl_b);
    return at.b != b.node_count;
  }
};

/// On pre-indexed trees; LevelUp climbs from parent to parent.
using Stackless = AlternatingStackless<LevelledPreTree>;
using LargeStackless = AlternatingStackless<LargeLevelledPreTree>;

}  // namespace flashbvh

#endif
