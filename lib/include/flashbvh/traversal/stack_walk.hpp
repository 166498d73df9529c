// The walk with a stack of pairs (the frame of algorithms 2 and 3); a rule says into which tree to
// descend.
//
// The array is the caller's, of stack_entries(a, b) entries. It cannot overflow: when (a, b) is
// popped, what remains are the later siblings of the nodes on the two paths from the roots, and
// Tree::stack_need counts the most of them that a path can have. The length is checked all the same
// before a query starts (Status::stack_too_small).
#ifndef FLASHBVH_TRAVERSAL_STACK_WALK_HPP
#define FLASHBVH_TRAVERSAL_STACK_WALK_HPP

#include <stdint.h>

#include "flashbvh/tree.hpp"
#include "flashbvh/walk.hpp"

namespace flashbvh {

/// The entries that a stack traversal of two trees with these stack needs can fill.
constexpr uint32_t stack_entries(uint32_t stack_need_a, uint32_t stack_need_b) {
  return stack_need_a + stack_need_b + 1;
}

/// Turns round the order of the entries from `first` to before `end`.
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
  using Entry = PairCursor<Index>;

  PairStack(Entry* entries, uint32_t capacity)
      : entries_(entries), top_(entries), capacity_(capacity) {
    if (capacity != 0) {
      push(0, 0);
    }
  }

  uint32_t capacity() const { return capacity_; }
  uint32_t size() const { return static_cast<uint32_t>(top_ - entries_); }
  bool is_empty() const { return top_ == entries_; }
  const Entry* entries() const { return entries_; }
  /// Behind the entry on top.
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
};

/// `Rule::descend_a(a, i, b, j)` says for two internal nodes whether to descend into A.
template <class TreeType, class Rule>
class StackWalk {
  using Index = typename TreeType::Index;

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
    const Node<Index>* const nodes_a = a.nodes;
    const Node<Index>* const nodes_b = b.nodes;
    Cursor stack = cursor;
    uint32_t at_a = 0;
    uint32_t at_b = 0;
    stack.pop(at_a, at_b);
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
        const Node<Index>& node_a = nodes_a[at_a];
        const Node<Index>& node_b = nodes_b[at_b];
        if (boxes_overlap(node_a.box, node_b.box)) {
          ++overlaps;
          const bool leaf_b = node_b.is_leaf();
          if (!node_a.is_leaf() && (leaf_b || Rule::descend_a(a, at_a, b, at_b))) {
            at_a = push_children(a, at_a, stack, [&](uint32_t child) { stack.push(child, at_b); });
            continue;
          }
          if (!leaf_b) {
            at_b = push_children(b, at_b, stack, [&](uint32_t child) { stack.push(at_a, child); });
            continue;
          }
          if (!(*outside.leaf_pair)(at_a, at_b)) {
            end = Walk::stopped;
            break;
          }
        }
      }
      if (stack.is_empty()) {
        break;
      }
      stack.pop(at_a, at_b);
    }
    if (end != Walk::done) {
      stack.push(at_a, at_b);
    }
    *outside.cursor = stack;
    outside.budget->visits_left = visits_left;
    outside.budget->overlaps = overlaps;
    return end;
  }

 private:
  using Entry = PairCursor<Index>;

  /// Pushes all children but the first, the last one first, and returns the first.
  template <class Push>
  static uint32_t push_children(const Tree& tree, uint32_t parent, Cursor& stack, Push push) {
    const uint32_t first = tree.first_child(parent);
    Entry* const bottom = stack.top();
    uint32_t child = first;
    while (!tree.is_last_child(parent, child)) {
      child = tree.next_sibling(child);
      push(child);
    }
    if (stack.top() > bottom + 1) {
      reverse_entries(bottom, stack.top());
    }
    return first;
  }
};

}  // namespace flashbvh

#endif
