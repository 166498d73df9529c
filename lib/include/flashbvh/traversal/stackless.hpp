// Algorithm 4 of the paper (section 7), the stackless algorithm, with the extensions of section 8:
// unbalanced trees of different heights, any number of children. proofs/walk/Stackless.v proves it.
//
// Visits: the pairs of algorithm 3 (alternating_stack.hpp), in its order.
// Needs: pre-indexed trees with levels and parents or, by section 8.3, post-indexed trees with
// levels and right child levels (levels.hpp); no ranks, no stack. Resumable by a cursor.
// Cost: constant time per visit on post-indexed trees, where LevelUp(i, x) = i - x. On pre-indexed
// ones LevelUp climbs from parent to parent, at most as often as the walk descended. About 75, 50
// and 48 instructions a visit on Cortex-M0, M3 and M4F, post-indexed 61, 41 and 42, by boxes.
//
// Invariant: the pair below (a, b) on algorithm 3's stack is a function of (a, b): of the two
// levels, of whether each node is a left child (one with a next sibling, or the root), and of the
// right child levels. `next` computes this function, case by case as in section 7.1.
//
// Section 8.1: while one node is a leaf, the walk of the other's subtree is the leaf algorithm;
// there, the levels differ by more than in the eight cases. Climbing along last children until the
// levels differ as they did at the leaf leads back to the eight cases.
//
// The walk ends when a node is the imaginary end node, the root's escape index.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/traversal/levels.hpp"

namespace flashbvh {

/// The traversal, for Query, on meshes with levels.
template <class TreeWithLevels>
class BasicStackless {
  using Index = typename TreeWithLevels::Index;
  static_assert(HasLevels<TreeWithLevels>::kValue, "stackless needs levels: traversal/levels.hpp");

 public:
  using Tree = TreeWithLevels;
  using OfTranslations = BasicStackless;
  using Cursor = detail::PairCursor<Index>;
  static constexpr bool kStartsAtRoots = true;
  static constexpr bool kStackless = true;
  static constexpr bool kBelowLeaves = false;

  static Cursor nodes(const Tree&, const Tree&, const Cursor& cursor) { return cursor; }
  /// Only below a leaf do levels differ by more than the alternating rule makes them.
  static bool can_visit(const Tree& a, const Tree& b, const Cursor& cursor) {
    const uint32_t level_a = a.level(cursor.a);
    const uint32_t level_b = b.level(cursor.b);
    return level_a > level_b ? b.nodes[cursor.b].is_leaf()
                             : level_b - level_a <= 1 || a.nodes[cursor.a].is_leaf();
  }

  static Cursor cursor_at(const Tree&, const Tree&, Index a, Index b) { return {a, b}; }

  BasicStackless(const Tree& a, const Tree& b, const Cursor& cursor)
      : tree_a_(a),
        tree_b_(b),
        a_(cursor.a),
        b_(cursor.b),
        lead_(static_cast<int32_t>(a.level(cursor.a)) - static_cast<int32_t>(b.level(cursor.b))) {}

  const Node<Index>& node_a() const { return tree_a_.nodes[a_]; }
  const Node<Index>& node_b() const { return tree_b_.nodes[b_]; }
  uint32_t index_a() const { return a_; }
  uint32_t index_b() const { return b_; }

  bool descend() {
    const bool leaf_b = node_b().is_leaf();
    if ((lead_ < 0 || leaf_b) && !node_a().is_leaf()) {
      a_ = tree_a_.first_child(a_);
      ++lead_;
      return true;
    }
    if (!leaf_b) {
      b_ = tree_b_.first_child(b_);
      --lead_;
      return true;
    }
    return false;
  }

  template <class Bound>
  void descend_inner(const Bound& /*bound*/) {
    if (lead_ < 0) {
      a_ = tree_a_.first_child(a_);
      ++lead_;
    } else {
      b_ = tree_b_.first_child(b_);
      --lead_;
    }
  }

  /// Moves to the element below this one on algorithm 3's stack. Returns false if there is none:
  /// then a node is its tree's end node.
  bool next() { return (lead_ >= 0 ? next_of_a() : next_of_b()) != 0; }

  /// The last descent's tree shows which node was a leaf first.
  detail::Side leaf() const {
    return lead_ < 0            ? node_a().is_leaf() ? detail::Side::a : detail::Side::none
           : node_b().is_leaf() ? detail::Side::b
                                : detail::Side::none;
  }
  uint32_t leaf_root() const { return lead_ < 0 ? b_ : a_; }
  uint32_t leaf_node() const { return leaf_root(); }

  void store(Cursor& cursor, bool /*ended*/) const {
    cursor = {static_cast<Index>(a_), static_cast<Index>(b_)};
  }
  void store_below(Cursor& cursor, detail::Side leaf, uint32_t node) const {
    store(cursor, false);
    (leaf == detail::Side::a ? cursor.b : cursor.a) = static_cast<Index>(node);
  }

 private:
  /// Level(a) = Level(b) + lead: the last descent was into A. The lead is 0 outside B's leaves.
  /// Returns 0 at the end.
  uint32_t next_of_a() {
    const auto lead = static_cast<uint32_t>(lead_);
    const uint32_t rcl_a = tree_a_.rcl(a_);
    if (rcl_a <= lead) {  // cases 1 and 2; 8.1: the leaf algorithm in A's subtree
      lead_ -= static_cast<int32_t>(rcl_a);
      return tree_a_.escape_from(a_, rcl_a);
    }
    const uint32_t rcl_b = tree_b_.rcl(b_);
    if (rcl_a - lead <= rcl_b) {  // case 7, a left child of A is reached first
      b_ = tree_b_.level_up(b_, rcl_a - lead);
      lead_ = 0;
      return tree_a_.escape_from(a_, rcl_a);
    }  // case 5 (rcl_b = 0); case 7, a left child of B is reached first
    a_ = tree_a_.level_up(a_, lead + rcl_b + 1);
    lead_ = -1;
    return tree_b_.escape_from(b_, rcl_b);
  }

  /// Level(a) = Level(b) - lag: the last descent was into B. The lag is 1 outside A's leaves.
  uint32_t next_of_b() {
    const auto lag = static_cast<uint32_t>(-lead_);
    const uint32_t rcl_b = tree_b_.rcl(b_);
    if (rcl_b < lag) {  // cases 3 and 4; 8.1: the leaf algorithm in B's subtree
      lead_ += static_cast<int32_t>(rcl_b);
      return tree_b_.escape_from(b_, rcl_b);
    }
    const uint32_t rcl_a = tree_a_.rcl(a_);
    if (rcl_a <= rcl_b - lag) {  // case 6 (rcl_a = 0); case 8, a left child of A is reached first
      b_ = tree_b_.level_up(b_, rcl_a + lag);
      lead_ = 0;
      return tree_a_.escape_from(a_, rcl_a);
    }  // case 8, a left child of B is reached first
    a_ = tree_a_.level_up(a_, rcl_b - lag + 1);
    lead_ = -1;
    return tree_b_.escape_from(b_, rcl_b);
  }

  const Tree& tree_a_;
  const Tree& tree_b_;
  uint32_t a_;
  uint32_t b_;
  int32_t lead_;  ///< Level(a) - Level(b), a function of the pair
};

/// On pre-indexed trees (section 7), and on post-indexed ones (section 8.3).
using Stackless = BasicStackless<PreMeshWithLevels>;
using StacklessPost = BasicStackless<MeshWithLevels>;

}  // namespace flashbvh
