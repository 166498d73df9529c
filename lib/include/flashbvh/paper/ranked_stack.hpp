// The rule of ranked.hpp with a stack: its reference, and its opponent in the benchmark. It is
// tuned as ranked.hpp is: node addresses in registers, pairs of indices on the stack, and the one
// later sibling that a binary node has is pushed without looking for more.
//
// Invariant: as algorithm 2. Post-indexed trees only.
#ifndef FLASHBVH_PAPER_RANKED_STACK_HPP
#define FLASHBVH_PAPER_RANKED_STACK_HPP

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/paper/pair_stack.hpp"

namespace flashbvh {

/// The order, for Query.
template <class TreeType>
class RankedStack {
  using Index = typename TreeType::Index;
  using NodeType = Node<Index>;
  using Entry = detail::PairCursor<Index>;
  static_assert(TreeType::kLayout == Layout::post_indexed, "ranked-stack: post-indexed trees");

 public:
  using Tree = TreeType;
  using Cursor = PairStack<Index>;
  static constexpr bool kStartsAtRoots = true;
  static constexpr bool kStackless = false;
  static constexpr bool kBelowLeaves = false;

  static Entry nodes(const Tree&, const Tree&, const Cursor& cursor) { return cursor.top()[-1]; }

  /// The pair on top of the stack is kept out of it while the walk runs.
  RankedStack(const Tree& a, const Tree& b, const Cursor& cursor)
      : root_a_(a.nodes),
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
    const int32_t rank_a = a_->rank();
    const int32_t rank_b = b_->rank();
    if (rank_a >= rank_b) {
      if (rank_a > 0) {
        top_ = push_siblings<&Entry::a, &Entry::b>(root_a_, a_, b_ - root_b_, top_);
        return true;
      }
    } else if (rank_b > 0) {
      top_ = push_siblings<&Entry::b, &Entry::a>(root_b_, b_, a_ - root_a_, top_);
      return true;
    }
    return false;
  }

  void descend_inner() { (void)descend(); }

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

  const NodeType* root_a_;
  const NodeType* root_b_;
  const Entry* bottom_;
  Entry* top_;
  const NodeType* a_;
  const NodeType* b_;
  typename Cursor::Below below_;  ///< as the walk began
};

}  // namespace flashbvh

#endif
