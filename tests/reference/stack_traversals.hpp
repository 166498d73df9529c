// Traversals with a stack of pairs. A rule chooses the tree to descend into:
//     VolumeStack        algorithm 2: into the box of larger volume
//     AlternatingStack   algorithm 3, on trees with levels
//     RankedStack        the rule of ranked.hpp: its reference, and its competitor in the benchmark
//
// Invariant: the stack holds exactly the pairs that remain to be visited, the next one on top.
//
// The caller provides the array, of stack_entries(a, b) entries. It cannot overflow: when (a, b) is
// popped, the remaining entries are the later siblings of the nodes on the two paths from the
// roots, and Tree::stack_need is the largest number of them on a path. A query still checks the
// length before it starts (Status::stack_too_small).
//
// Tuned like ranked.hpp: node addresses in registers, pairs of indices on the stack, and the only
// later sibling in a binary tree is pushed without a loop.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh {

/// An element of a stack's array.
template <class Index>
using StackEntry = detail::PairCursor<Index>;

/// The entries that a stack traversal on two meshes with these stack needs can fill.
constexpr uint32_t stack_entries(uint32_t stack_need_a, uint32_t stack_need_b) {
  return stack_need_a + stack_need_b + 1;
}

/// Reverses the order of the entries from `first` to before `end`.
template <class Entry>
void reverse_entries(Entry* first, Entry* end) {
  for (Entry* last = end - 1; first < last; ++first, --last) {
    const Entry entry = *first;
    *first = *last;
    *last = entry;
  }
}

/// A stack of pairs in the caller's array, at the start of a walk: only the roots. The constructor
/// writes them, so an array and its stack serve one query.
template <class Index>
class PairStack {
 public:
  using Entry = detail::PairCursor<Index>;

  PairStack(Entry* entries, uint32_t capacity)
      : entries_(entries), top_(entries), capacity_(capacity) {
    if (capacity != 0) {
      *top_ = {0, 0};
      ++top_;
    }
  }

  template <class Tree>
  bool fits(const Tree& a, const Tree& b) const {
    return capacity_ >= stack_entries(a.stack_need, b.stack_need);
  }
  /// The state of a walk below a leaf, whose pair is on top: the side of the leaf, and the next
  /// node of the other tree.
  struct Below {
    detail::Side leaf = detail::Side::none;
    Index node = 0;
  };
  const Below& below() const { return below_; }
  void set_below(const Below& below) { below_ = below; }

  uint32_t size() const { return static_cast<uint32_t>(top_ - entries_); }
  const Entry* entries() const { return entries_; }
  /// The address after the top entry.
  Entry* top() const { return top_; }
  void set_top(Entry* top) { top_ = top; }

 private:
  Entry* entries_;
  Entry* top_;
  uint32_t capacity_;
  Below below_;
};

/// `Rule::into(a, i, b, j)`: the tree to descend into from the nodes i and j; none for two leaves.
template <class TreeType, class Rule>
class StackOrder {
  using Index = typename TreeType::Index;
  using NodeType = Node<Index>;
  using Entry = detail::PairCursor<Index>;

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
      case detail::Side::a:
        top_ = push_siblings<&Entry::a, &Entry::b>(root_a_, a_, b_ - root_b_, top_);
        return true;
      case detail::Side::b:
        top_ = push_siblings<&Entry::b, &Entry::a>(root_b_, b_, a_ - root_a_, top_);
        return true;
      case detail::Side::none:
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

  detail::Side leaf() const { return below_.leaf; }
  uint32_t leaf_root() const { return leaf() == detail::Side::a ? index_b() : index_a(); }
  uint32_t leaf_node() const { return below_.node; }
  void store_below(Cursor& cursor, detail::Side leaf, uint32_t node) const {
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
detail::Side side_of(const Node* a, const Node* b, const PrefersA& prefers_a) {
  if (!a->is_leaf() && (b->is_leaf() || prefers_a())) {
    return detail::Side::a;
  }
  return b->is_leaf() ? detail::Side::none : detail::Side::b;
}

/// The volume in cells cubed, below 2^45.
constexpr uint64_t volume(const PackedBox& box) {
  return uint64_t{detail::extent_x(box)} * detail::extent_y(box) * detail::extent_z(box);
}

/// Descends into the larger box, into A on ties: the paper's line 9 says B if A has less volume.
struct VolumeRule {
  template <class Tree, class Node>
  static detail::Side into(const Tree&, const Node* a, const Tree&, const Node* b) {
    return side_of(a, b, [&] { return volume(a->box) >= volume(b->box); });
  }
};

/// Descends into the node of lower level, into B on ties; if one is a leaf, into the other (section
/// 8.1). Invariant (property 6.1): while both nodes are inner ones, level(a) = level(b) or
/// level(a) = level(b) - 1.
struct AlternatingRule {
  template <class TreeWithLevels, class Node>
  static detail::Side into(const TreeWithLevels& tree_a, const Node* a,
                           const TreeWithLevels& tree_b, const Node* b) {
    return side_of(a, b, [&] {
      return tree_a.level(static_cast<uint32_t>(a - tree_a.nodes)) <
             tree_b.level(static_cast<uint32_t>(b - tree_b.nodes));
    });
  }
};

/// Descends into the node of larger rank, into A on ties. Leaves have rank 0, inner nodes more.
struct RankRule {
  template <class Tree, class Node>
  static detail::Side into(const Tree&, const Node* a, const Tree&, const Node* b) {
    static_assert(Tree::kLayout == Layout::post_indexed, "ranked-stack: post-indexed trees");
    const int32_t rank_a = a->rank();
    const int32_t rank_b = b->rank();
    if (rank_a >= rank_b) {
      return rank_a > 0 ? detail::Side::a : detail::Side::none;
    }
    return rank_b > 0 ? detail::Side::b : detail::Side::none;
  }
};

template <class Tree>
using VolumeStack = StackOrder<Tree, VolumeRule>;
template <class TreeWithLevels>
using AlternatingStack = StackOrder<TreeWithLevels, AlternatingRule>;
template <class Tree>
using RankedStack = StackOrder<Tree, RankRule>;

}  // namespace flashbvh
