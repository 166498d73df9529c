// The stack of the traversals with a stack: an array of pairs that the caller provides.
//
// An array of stack_entries(a, b) entries cannot overflow: when (a, b) is popped, the remaining
// entries are the later siblings of the nodes on the two paths from the roots, and
// Tree::stack_need is the largest number of them on a path. A query checks the length before it
// starts (Status::stack_too_small). Baked C files have the need as NAME_STACK_NEED:
//
//     StackEntry<uint16_t> entries[stack_entries(plate_STACK_NEED, peg_STACK_NEED)];
//     PairStack<uint16_t> stack(entries, sizeof entries / sizeof entries[0]);
//     Query<VolumeStack> query(plate, peg, pose, stack);
#pragma once

#include <stdint.h>

#include "flashbvh/detail/walk/walk_run.hpp"

namespace flashbvh {

/// An element of a stack's array.
template <class Index>
using StackEntry = detail::PairCursor<Index>;

/// The entries that a stack traversal on two meshes with these stack needs can fill.
constexpr uint32_t stack_entries(uint32_t stack_need_a, uint32_t stack_need_b) {
  return stack_need_a + stack_need_b + 1;
}

/// A stack of pairs in the caller's array, at the start of a walk: only the roots. The constructor
/// writes them, so an array and its stack serve one query.
template <class Index>
class PairStack {
 public:
  using Entry = detail::PairCursor<Index>;

  /// `entries` must outlive the query.
  PairStack(Entry* entries, uint32_t capacity)
      : entries_(entries), top_(entries), capacity_(capacity) {
    if (capacity != 0) {
      *top_ = {0, 0};
      ++top_;
    }
  }

  /// True if the array is long enough for a walk over these trees.
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
  /// For the walk: this state.
  const Below& below() const { return below_; }
  /// For the walk: sets it.
  void set_below(const Below& below) { below_ = below; }

  /// The pairs on the stack.
  uint32_t size() const { return static_cast<uint32_t>(top_ - entries_); }
  /// The array, the bottom first.
  const Entry* entries() const { return entries_; }
  /// The address after the top entry.
  Entry* top() const { return top_; }
  /// For the walk: sets it.
  void set_top(Entry* top) { top_ = top; }

 private:
  Entry* entries_;
  Entry* top_;
  uint32_t capacity_;
  Below below_;
};

}  // namespace flashbvh
