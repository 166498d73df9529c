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

  PairStack(Entry* entries, uint32_t capacity)
      : entries_(entries), top_(entries), capacity_(capacity) {
    if (capacity != 0) {
      push({0, 0});
    }
  }

  uint32_t capacity() const { return capacity_; }
  uint32_t size() const { return static_cast<uint32_t>(top_ - entries_); }
  bool is_empty() const { return top_ == entries_; }
  const Entry* entries() const { return entries_; }
  Entry* top() const { return top_; }

  void push(Entry entry) { *top_++ = entry; }
  Entry pop() { return *--top_; }

  /// Turns round the order of the entries from `bottom` on.
  void reverse_from(Entry* bottom) {
    for (Entry* last = top_ - 1; bottom < last; ++bottom, --last) {
      const Entry entry = *bottom;
      *bottom = *last;
      *last = entry;
    }
  }

 private:
  Entry* entries_;
  Entry* top_;  ///< behind the entry on top
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
    Cursor stack = cursor;
    Entry pair = stack.pop();
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
        const Node<Index>& node_a = a.nodes[pair.a];
        const Node<Index>& node_b = b.nodes[pair.b];
        if (boxes_overlap(node_a.box, node_b.box)) {
          ++overlaps;
          if (!node_a.is_leaf() && (node_b.is_leaf() || Rule::descend_a(a, pair.a, b, pair.b))) {
            pair.a = push_children(a, pair.a, stack, [&](Index child) {
              return Entry{child, pair.b};
            });
            continue;
          }
          if (!node_b.is_leaf()) {
            pair.b = push_children(b, pair.b, stack, [&](Index child) {
              return Entry{pair.a, child};
            });
            continue;
          }
          if (!(*outside.leaf_pair)(pair.a, pair.b)) {
            end = Walk::stopped;
            break;
          }
        }
      }
      if (stack.is_empty()) {
        break;
      }
      pair = stack.pop();
    }
    if (end != Walk::done) {
      stack.push(pair);
    }
    *outside.cursor = stack;
    outside.budget->visits_left = visits_left;
    outside.budget->overlaps = overlaps;
    return end;
  }

 private:
  using Entry = PairCursor<Index>;

  /// Pushes all children but the first, the last one first, and returns the first.
  template <class EntryOf>
  static Index push_children(const Tree& tree, uint32_t parent, Cursor& stack, EntryOf entry_of) {
    const uint32_t first = tree.first_child(parent);
    Entry* const bottom = stack.top();
    for (uint32_t child = first; !tree.is_last_child(parent, child);) {
      child = tree.next_sibling(child);
      stack.push(entry_of(static_cast<Index>(child)));
    }
    stack.reverse_from(bottom);
    return static_cast<Index>(first);
  }
};

}  // namespace flashbvh

#endif
