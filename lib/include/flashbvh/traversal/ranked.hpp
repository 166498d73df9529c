// The stackless traversal `ranked`, in the order of a dynamic rule: the library's default, and an
// answer to the paper's question for a predictable rule of fewer iterations (section 11).
//
// Visits: about those of a volume rule: 0.985 of volume_stack.hpp's on the paper's setups.
// Needs: post-indexed trees, whose nodes hold ranks; no levels, no stack. Resumable by a cursor.
// Cost: each ascent undoes a descent: amortised constant time per visit. About 51, 37 and 31
// instructions a visit on Cortex-M0, M3 and M4F, translated, by boxes.
//
// Every internal node has a rank that never grows from a parent to its child (a quantised size of
// its box); leaves have none. The rule: descend into the node of the larger rank, into A on a tie.
//
// Invariant: at every visited pair rank(a) < rank(parent of b) and rank(b) <= rank(parent of a). It
// holds at the roots, and each descent keeps it. So the last descent was into the node of smaller
// rank among parent(a) and parent(b), B's on a tie. Hence the pair after (a, b) is a function of
// the pair. A root's missing parent counts as kRootParentRank, above every real rank. So a root is
// left last, and the walk is over when both nodes are roots. proofs/walk proves all of it.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh {

/// The traversal, for Query, on post-indexed meshes.
template <class TreeType>
class Ranked {
  using Index = typename TreeType::Index;
  using NodeType = Node<Index>;
  static_assert(TreeType::kLayout == Layout::post_indexed, "ranked walks post-indexed trees");

 public:
  using Tree = TreeType;
  using OfTranslations = Ranked;
  using Cursor = detail::PairCursor<Index>;
  static constexpr bool kStartsAtRoots = true;
  static constexpr bool kStackless = true;
  static constexpr bool kBelowLeaves = false;

  static Cursor nodes(const Tree&, const Tree&, const Cursor& cursor) { return cursor; }
  /// True if the invariant holds: exactly for the pairs that a walk visits if all boxes overlap.
  static bool can_visit(const Tree& a, const Tree& b, const Cursor& cursor) {
    return a.nodes[cursor.a].rank() < find_parent_rank(b, cursor.b) &&
           b.nodes[cursor.b].rank() <= find_parent_rank(a, cursor.a);
  }

  static Cursor cursor_at(const Tree&, const Tree&, Index a, Index b) { return {a, b}; }

  Ranked(const Tree& a, const Tree& b, const Cursor& cursor) : b_(b, cursor.b), a_(a, cursor.a) {}

  const NodeType& node_a() const { return *a_.node; }
  const NodeType& node_b() const { return *b_.node; }
  uint32_t index_a() const { return a_.node_index(); }
  uint32_t index_b() const { return b_.node_index(); }

  FLASHBVH_INLINE bool descend() {
    const int32_t rank_a = a_.node->rank();
    const int32_t rank_b = b_.node->rank();
    if (rank_a < rank_b) {
      if (rank_b > 0) {
        b_.descend(rank_b);
        return true;
      }
    } else if (rank_a >= 0) {
      a_.descend(rank_a);
      return true;
    }
    return false;
  }
  /// descend() at a pair of internal nodes, without its tests for leaves.
  template <class Bound>
  FLASHBVH_INLINE void descend_inner(const Bound& /*bound*/) {
    const int32_t rank_a = a_.node->rank();
    const int32_t rank_b = b_.node->rank();
    if (rank_a < rank_b) {
      b_.descend(rank_b);
    } else {
      a_.descend(rank_a);
    }
  }

  bool next() {
    for (;;) {
      if (b_.parent_rank <= a_.parent_rank) {
        if (b_.next_sibling()) {
          return true;
        }
        if (b_.node == b_.root) {
          return false;
        }
        b_.ascend();
      } else {
        if (a_.next_sibling()) {
          return true;
        }
        a_.ascend();
      }
    }
  }

  /// The side whose node was a leaf first, or none; the last descent was into the other side.
  detail::Side leaf() const {
    const bool into_b = b_.parent_rank <= a_.parent_rank;
    const bool below_leaf = into_b ? a_.node->is_leaf() : b_.node->is_leaf();
    return !below_leaf ? detail::Side::none : into_b ? detail::Side::a : detail::Side::b;
  }
  uint32_t leaf_root() const { return leaf() == detail::Side::a ? index_b() : index_a(); }
  uint32_t leaf_node() const { return leaf_root(); }

  void store(Cursor& cursor, bool /*ended*/) const { cursor = {a_.node_index(), b_.node_index()}; }
  void store_below(Cursor& cursor, detail::Side leaf, uint32_t node) const {
    store(cursor, false);
    (leaf == detail::Side::a ? cursor.b : cursor.a) = static_cast<Index>(node);
  }

 protected:
  /// The walk's node in one of the trees.
  struct Place {
    const NodeType* root;
    const NodeType* node;
    int32_t parent_rank;

    Place(const Tree& tree, Index index)
        : root(tree.nodes), node(tree.nodes + index), parent_rank(find_parent_rank(tree, index)) {}

    Index node_index() const { return static_cast<Index>(node - root); }

    void descend(int32_t rank) {
      parent_rank = rank;
      node = root + node[1].link;
    }

    /// Moves to the next sibling; false, without a move, if there is none. A root has none.
    bool next_sibling() {
      const NodeType* const next = root + node->link;
      if (next < node) {
        node = next;
        return true;
      }
      return false;
    }

    /// Moves to the last sibling.
    void skip_siblings() {
      while (root + node->link < node) {
        node = root + node->link;
      }
    }

    /// Moves from a last child to its parent.
    void ascend() {
      --node;
      parent_rank = node->parent_rank();
    }
  };

  /// Finds the rank of any node's parent, in as many steps as the node has later siblings.
  static int32_t find_parent_rank(const Tree& tree, uint32_t index) {
    if (index == 0) {
      return kRootParentRank;
    }
    while (tree.nodes[index].link < index) {
      index = tree.nodes[index].link;
    }
    return tree.nodes[index - 1].rank();
  }

  Place b_;
  Place a_;
};

}  // namespace flashbvh
