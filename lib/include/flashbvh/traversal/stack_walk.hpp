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

/// A stack of pairs in the caller's array, at the start of a walk: the roots and nothing else.
template <class Index>
class PairStack {
 public:
  using Entry = PairCursor<Index>;

  PairStack(Entry* entries, uint32_t capacity) : entries_(entries), size_(0), capacity_(capacity) {
    if (capacity != 0) {
      push(0, 0);
    }
  }

  uint32_t capacity() const { return capacity_; }
  uint32_t size() const { return size_; }
  const Entry* entries() const { return entries_; }

  void push(uint32_t a, uint32_t b) {
    entries_[size_].a = static_cast<Index>(a);
    entries_[size_].b = static_cast<Index>(b);
    ++size_;
  }
  Entry pop() { return entries_[--size_]; }

  /// Turns round the order of the entries from `first` on: the one pushed first gets popped first.
  void reverse_from(uint32_t first) {
    for (uint32_t last = size_ - 1; first < last; ++first, --last) {
      const Entry entry = entries_[first];
      entries_[first] = entries_[last];
      entries_[last] = entry;
    }
  }

 private:
  Entry* entries_;
  uint32_t size_;
  uint32_t capacity_;
};

/// `Rule::descend_a(a, i, b, j)` says for two internal nodes whether to descend into A.
template <class TreeType, class Rule>
class StackWalk {
  using Index = typename TreeType::Index;

 public:
  using Tree = TreeType;
  using Cursor = PairStack<Index>;

  template <class Overlap, class LeafPair>
  static Walk run(const Tree& a, const Tree& b, const Overlap& overlap, Cursor& cursor,
                  Budget& budget, LeafPair&& leaf_pair) {
    Cursor stack = cursor;  // a copy the compiler can keep in registers
    if (budget.behind) {
      stack.pop();
    }
    Walk end = Walk::done;
    while (stack.size() != 0) {
      if (budget.visits_left == 0) {
        end = Walk::suspended;
        break;
      }
      --budget.visits_left;
      const PairCursor<Index> pair = stack.pop();
      const Node<Index>& node_a = a.nodes[pair.a];
      const Node<Index>& node_b = b.nodes[pair.b];
      if (!overlap(node_a.box, node_b.box)) {
        continue;
      }
      ++budget.overlaps;
      if (!node_a.is_leaf() && (node_b.is_leaf() || Rule::descend_a(a, pair.a, b, pair.b))) {
        push_children_of_a(a, pair, stack);
      } else if (!node_b.is_leaf()) {
        push_children_of_b(b, pair, stack);
      } else if (!leaf_pair(pair.a, pair.b)) {
        stack.push(pair.a, pair.b);
        end = Walk::stopped;
        break;
      }
    }
    cursor = stack;
    return end;
  }

 private:
  /// The last child first, so that the first one is popped first.
  static void push_children_of_a(const Tree& a, PairCursor<Index> pair, Cursor& stack) {
    const uint32_t first = stack.size();
    uint32_t child = a.first_child(pair.a);
    stack.push(child, pair.b);
    while (!a.is_last_child(pair.a, child)) {
      child = a.next_sibling(child);
      stack.push(child, pair.b);
    }
    stack.reverse_from(first);
  }

  static void push_children_of_b(const Tree& b, PairCursor<Index> pair, Cursor& stack) {
    const uint32_t first = stack.size();
    uint32_t child = b.first_child(pair.b);
    stack.push(pair.a, child);
    while (!b.is_last_child(pair.b, child)) {
      child = b.next_sibling(child);
      stack.push(pair.a, child);
    }
    stack.reverse_from(first);
  }
};

}  // namespace flashbvh

#endif
