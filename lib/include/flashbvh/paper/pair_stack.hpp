// The order with a stack of pairs (the frame of algorithms 2 and 3); a rule says into which tree to
// descend.
//
// The array is the caller's, of stack_entries(a, b) entries. It cannot overflow: when (a, b) is
// popped, what remains are the later siblings of the nodes on the two paths from the roots, and
// Tree::stack_need counts the most of them that a path can have. The length is checked all the same
// before a query starts (Status::stack_too_small).
#ifndef FLASHBVH_PAPER_PAIR_STACK_HPP
#define FLASHBVH_PAPER_PAIR_STACK_HPP

#include <stdint.h>

#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh {

/// The entries that a stack order on two meshes with these stack needs can fill.
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

/// A stack of pairs in the caller's array, at the start of a walk: the roots and nothing else.
/// Making one writes them: an array and what was made of it serve one query.
template <class Index>
class PairStack {
 public:
  using Entry = detail::PairCursor<Index>;

  PairStack(Entry* entries, uint32_t capacity)
      : entries_(entries), top_(entries), capacity_(capacity) {
    if (capacity != 0) {
      push(0, 0);
    }
  }

  template <class Tree>
  bool fits(const Tree& a, const Tree& b) const {
    return capacity_ >= stack_entries(a.stack_need, b.stack_need);
  }
  /// Where a walk is below a leaf, whose pair is on top: which node is the leaf, and which node of
  /// the other tree is due.
  struct Below {
    detail::Side leaf = detail::Side::none;
    Index node = 0;
  };
  const Below& below() const { return below_; }
  void set_below(const Below& below) { below_ = below; }

  uint32_t size() const { return static_cast<uint32_t>(top_ - entries_); }
  bool is_empty() const { return top_ == entries_; }
  const Entry* entries() const { return entries_; }
  /// After the entry on top.
  Entry* top() const { return top_; }
  void set_top(Entry* top) { top_ = top; }

  void push(uint32_t a, uint32_t b) {
    top_->a = static_cast<Index>(a);
    top_->b = static_cast<Index>(b);
    ++top_;
  }
  void pop(uint32_t& a, uint32_t& b) {
    --top_;
    a = top_->a;
    b = top_->b;
  }

 private:
  Entry* entries_;
  Entry* top_;
  uint32_t capacity_;
  Below below_;
};

/// `Rule::descend_a(a, i, b, j)` says for two internal nodes whether to descend into A.
template <class TreeType, class Rule>
class StackOrder {
  using Index = typename TreeType::Index;
  using Entry = detail::PairCursor<Index>;

 public:
  using Tree = TreeType;
  using Cursor = PairStack<Index>;
  static constexpr bool kStartsAtRoots = true;
  static constexpr bool kStackless = false;
  static constexpr bool kBelowLeaves = false;

  static Entry nodes(const Tree&, const Tree&, const Cursor& cursor) { return cursor.top()[-1]; }

  /// The pair on top of the stack is kept out of it while the walk runs.
  StackOrder(const Tree& a, const Tree& b, const Cursor& cursor)
      : tree_a_(a), tree_b_(b), nodes_a_(a.nodes), nodes_b_(b.nodes), stack_(cursor) {
    stack_.pop(a_, b_);
  }

  const Node<Index>& node_a() const { return nodes_a_[a_]; }
  const Node<Index>& node_b() const { return nodes_b_[b_]; }
  uint32_t index_a() const { return a_; }
  uint32_t index_b() const { return b_; }

  bool descend() {
    const bool leaf_b = node_b().is_leaf();
    if (!node_a().is_leaf() && (leaf_b || Rule::descend_a(tree_a_, a_, tree_b_, b_))) {
      a_ = push_children(tree_a_, a_, [this](uint32_t child) { stack_.push(child, b_); });
      return true;
    }
    if (!leaf_b) {
      b_ = push_children(tree_b_, b_, [this](uint32_t child) { stack_.push(a_, child); });
      return true;
    }
    return false;
  }
  void descend_inner() { (void)descend(); }

  bool next() {
    if (stack_.is_empty()) {
      return false;
    }
    stack_.pop(a_, b_);
    return true;
  }

  void store(Cursor& cursor, bool ended) {
    if (!ended) {
      stack_.push(a_, b_);
    }
    cursor = stack_;
    cursor.set_below({});
  }

  detail::Side leaf() const { return stack_.below().leaf; }
  uint32_t leaf_root() const { return leaf() == detail::Side::a ? b_ : a_; }
  uint32_t leaf_node() const { return stack_.below().node; }
  void store_below(Cursor& cursor, detail::Side leaf, uint32_t node) const {
    cursor = stack_;
    cursor.push(a_, b_);
    cursor.set_below({leaf, static_cast<Index>(node)});
  }

 private:
  /// Pushes all children but the first, the last one first, and returns the first.
  template <class Push>
  uint32_t push_children(const Tree& tree, uint32_t parent, Push push) {
    const uint32_t first = tree.first_child(parent);
    Entry* const bottom = stack_.top();
    uint32_t child = first;
    while (!tree.is_last_child(parent, child)) {
      child = tree.next_sibling(child);
      push(child);
    }
    if (stack_.top() > bottom + 1) {
      reverse_entries(bottom, stack_.top());
    }
    return first;
  }

  const Tree& tree_a_;
  const Tree& tree_b_;
  const Node<Index>* nodes_a_;
  const Node<Index>* nodes_b_;
  Cursor stack_;
  uint32_t a_;
  uint32_t b_;
};

}  // namespace flashbvh

#endif
