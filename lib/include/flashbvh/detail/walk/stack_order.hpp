// Traversals with a stack of pairs (traversal/pair_stack.hpp), by the rule that chooses the tree to
// descend into.
//
// Invariant: the stack holds exactly the pairs that remain to be visited, the next one on top.
//
// Node addresses live in registers, pairs of indices on the stack, and the only later sibling in a
// binary tree is pushed without a loop.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/traversal/pair_stack.hpp"

namespace flashbvh::detail {

/// Reverses the order of the entries from `first` to before `end`.
template <class Entry>
void reverse_entries(Entry* first, Entry* end) {
  for (Entry* last = end - 1; first < last; ++first, --last) {
    const Entry entry = *first;
    *first = *last;
    *last = entry;
  }
}

/// `Rule::into(a, i, b, j)`: the tree to descend into from the nodes i and j; none for two leaves.
template <class TreeType, class Rule>
class StackOrder {
  using Index = typename TreeType::Index;
  using NodeType = Node<Index>;
  using Entry = PairCursor<Index>;

 public:
  using Tree = TreeType;
  using OfTranslations = StackOrder;
  using Cursor = PairStack<Index>;
  static constexpr bool kStartsAtRoots = true;
  static constexpr bool kStackless = false;
  static constexpr bool kBelowLeaves = false;

  static Entry nodes(const Tree&, const Tree&, const Cursor& cursor) { return cursor.top()[-1]; }

  /// During the walk, the top pair is kept outside the stack.
  StackOrder(const Tree& a, const Tree& b, const Cursor& cursor)
      : tree_a_(a),
        tree_b_(b),
        root_a_(a.nodes),
        root_b_(b.nodes),
        bottom_(cursor.entries()),
        top_(cursor.top() - 1),
        a_(root_a_ + top_->a),
        b_(root_b_ + top_->b),
        below_(cursor.below()) {}

  const NodeType& node_a() const { return *a_; }
  const NodeType& node_b() const { return *b_; }
  uint32_t index_a() const { return static_cast<uint32_t>(a_ - root_a_); }
  uint32_t index_b() const { return static_cast<uint32_t>(b_ - root_b_); }

  bool descend() {
    switch (Rule::into(tree_a_, a_, tree_b_, b_)) {
      case Side::a:
        top_ = push_siblings<&Entry::a, &Entry::b>(root_a_, a_, b_ - root_b_, top_);
        return true;
      case Side::b:
        top_ = push_siblings<&Entry::b, &Entry::a>(root_b_, b_, a_ - root_a_, top_);
        return true;
      case Side::none:
        break;
    }
    return false;
  }
  template <class Bound>
  void descend_inner(const Bound& /*bound*/) {
    (void)descend();
  }

  bool next() {
    if (top_ == bottom_) {
      return false;
    }
    --top_;
    a_ = root_a_ + top_->a;
    b_ = root_b_ + top_->b;
    return true;
  }

  void store(Cursor& cursor, bool ended) {
    if (!ended) {
      *top_ = {static_cast<Index>(index_a()), static_cast<Index>(index_b())};
      ++top_;
    }
    cursor.set_top(top_);
    cursor.set_below({});
  }

  Side leaf() const { return below_.leaf; }
  uint32_t leaf_root() const { return leaf() == Side::a ? index_b() : index_a(); }
  uint32_t leaf_node() const { return below_.node; }
  void store_below(Cursor& cursor, Side leaf, uint32_t node) const {
    *top_ = {static_cast<Index>(index_a()), static_cast<Index>(index_b())};
    cursor.set_top(top_ + 1);
    cursor.set_below({leaf, static_cast<Index>(node)});
  }

 private:
  // Tree's functions of these names, by addresses.
  static const NodeType* first_child(const NodeType* root, const NodeType* node) {
    return Tree::kLayout == Layout::pre_indexed ? node + 1 : root + node[1].link;
  }
  static bool is_last_child(const NodeType* parent, const NodeType* child) {
    return Tree::kLayout == Layout::pre_indexed ? child->link == parent->link : child == parent + 1;
  }

  /// Moves to the first child of `node` and pushes the others, the last one first. `own` and
  /// `other`: the members of an entry for this tree and for the other one.
  template <Index Entry::*own, Index Entry::*other>
  static Entry* push_siblings(const NodeType* root, const NodeType*& node, ptrdiff_t other_node,
                              Entry* top) {
    const NodeType* const parent = node;
    node = first_child(root, parent);
    if (is_last_child(parent, node)) {
      return top;
    }
    const NodeType* const next = root + node->link;
    if (!is_last_child(parent, next)) {
      return push_many<own, other>(root, parent, next, static_cast<Index>(other_node), top);
    }
    top->*own = static_cast<Index>(next - root);
    top->*other = static_cast<Index>(other_node);
    return top + 1;
  }

  template <Index Entry::*own, Index Entry::*other>
  FLASHBVH_NOINLINE static Entry* push_many(const NodeType* root, const NodeType* parent,
                                            const NodeType* child, Index other_node, Entry* top) {
    Entry* const first = top;
    for (;; child = root + child->link) {
      top->*own = static_cast<Index>(child - root);
      top->*other = other_node;
      ++top;
      if (is_last_child(parent, child)) {
        break;
      }
    }
    reverse_entries(first, top);
    return top;
  }

  const Tree& tree_a_;
  const Tree& tree_b_;
  const NodeType* root_a_;
  const NodeType* root_b_;
  const Entry* bottom_;
  Entry* top_;
  const NodeType* a_;
  const NodeType* b_;
  typename Cursor::Below below_;  ///< at the walk's start
};

/// The side for a rule that compares two inner nodes: at a leaf there is no choice.
template <class Node, class PrefersA>
Side side_of(const Node* a, const Node* b, const PrefersA& prefers_a) {
  if (!a->is_leaf() && (b->is_leaf() || prefers_a())) {
    return Side::a;
  }
  return b->is_leaf() ? Side::none : Side::b;
}

}  // namespace flashbvh::detail
