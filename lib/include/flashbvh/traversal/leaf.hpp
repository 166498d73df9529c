// Algorithm 1 of the paper (section 3), the leaf algorithm: each leaf of A against the whole of B.
//
// Visits: for each leaf of A, from left to right, the nodes of B in array order, over the subtrees
// of boxes that do not overlap. So at least one visit for each leaf of A, also of separated meshes.
// Needs: a tree in either layout; no levels, no ranks, no stack. Resumable by a cursor.
// Cost: on a pre-indexed tree, constant time per visit, the least of all traversals. On a
// post-indexed one the step from a last child climbs its chain of last children. About 44, 37 and
// 32 instructions a visit on Cortex-M0, M3 and M4F, translated, by boxes.
//
// Invariant: the leaves of A before `a` are done; for leaf `a`, so are B's nodes before `b`.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh {

/// The traversal, for Query, on meshes of the type `TreeType`.
template <class TreeType>
class BasicLeaf {
  using Index = typename TreeType::Index;
  static constexpr bool kPost = TreeType::kLayout == Layout::post_indexed;

 public:
  using Tree = TreeType;
  using OfTranslations = BasicLeaf;
  /// `a`: the number of A's nodes that are passed, from left to right; `b`: the node of B.
  using Cursor = detail::PairCursor<Index>;
  static constexpr bool kStartsAtRoots = false;
  static constexpr bool kStackless = true;
  static constexpr bool kBelowLeaves = true;

  static Cursor nodes(const Tree& a, const Tree&, const Cursor& cursor) {
    return {static_cast<Index>(left_to_right(a, cursor.a)), cursor.b};
  }
  static Cursor cursor_at(const Tree& a, const Tree&, Index node_a, Index node_b) {
    return {static_cast<Index>(left_to_right(a, node_a)), node_b};
  }
  static bool can_visit(const Tree& a, const Tree& b, const Cursor& cursor) {
    return a.nodes[nodes(a, b, cursor).a].is_leaf();
  }

  BasicLeaf(const Tree& a, const Tree& b, const Cursor& cursor)
      : tree_a_(a), tree_b_(b), passed_(cursor.a), b_(cursor.b) {
    (void)to_leaf();  // every tree has one
  }

  const Node<Index>& node_a() const { return tree_a_.nodes[index_a()]; }
  const Node<Index>& node_b() const { return tree_b_.nodes[b_]; }
  uint32_t index_a() const { return left_to_right(tree_a_, passed_); }
  uint32_t index_b() const { return b_; }

  bool descend() {
    if (node_b().is_leaf()) {
      return false;
    }
    b_ = tree_b_.first_child(b_);
    return true;
  }

  /// The whole walk runs in B's subtrees below leaves of A.
  detail::Side leaf() const { return detail::Side::a; }
  uint32_t leaf_root() const { return b_; }
  uint32_t leaf_node() const { return leaf_root(); }

  bool next() {
    b_ = escape(tree_b_, b_);
    if (b_ != tree_b_.node_count) {
      return true;
    }
    b_ = 0;
    ++passed_;
    return to_leaf();
  }

  /// A finished walk stores no place, since it is never resumed.
  void store(Cursor& cursor, bool ended) const {
    if (!ended) {
      cursor = {static_cast<Index>(passed_), static_cast<Index>(b_)};
    }
  }
  void store_below(Cursor& cursor, detail::Side /*leaf*/, uint32_t node) const {
    cursor = {static_cast<Index>(passed_), static_cast<Index>(node)};
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

  /// Moves to the first leaf of A that is not passed.
  bool to_leaf() {
    while (passed_ < tree_a_.node_count && !node_a().is_leaf()) {
      ++passed_;
    }
    return passed_ < tree_a_.node_count;
  }

  const Tree& tree_a_;
  const Tree& tree_b_;
  uint32_t passed_;
  uint32_t b_;
};

/// On pre-indexed trees, as in the paper, and on post-indexed ones.
using Leaf = BasicLeaf<PreMesh>;
using LeafPost = BasicLeaf<Mesh>;

}  // namespace flashbvh
