// All traversals on each layout, and a start cursor for each, with or
// without a stack. Uses no C++ library.
#pragma once

#include <stdint.h>

#include "flashbvh/traversal/traversals.hpp"
#include "support/ranked_stack.hpp"

namespace flashbvh::test {

/// The start cursor of a walk; if it needs a stack, on these entries.
template <class Traversal>
typename Traversal::Cursor at_roots(
    [[maybe_unused]] detail::PairCursor<typename Traversal::Tree::Index>* entries,
    [[maybe_unused]] uint32_t count) {
  if constexpr (Traversal::kStackless) {
    return {};
  } else {
    return {entries, count};
  }
}

inline bool same(const QueryStats& a, const QueryStats& b) {
  return a.visits == b.visits && a.overlaps == b.overlaps && a.leaf_pairs == b.leaf_pairs &&
         a.triangle_pairs == b.triangle_pairs;
}

template <class OrderType>
struct NamedOrder {
  using Traversal = OrderType;
  const char* name;
};

/// Calls use(NamedOrder<...>) for each traversal on each layout it supports, pre-indexed first, and
/// for the oracle of `ranked`.
template <class Index, class Use>
void for_each_order(Use&& use) {
  for_each_traversal([&use](auto traversal) {
    using Traversal = decltype(traversal);
    if constexpr (Traversal::walks(Layout::pre_indexed)) {
      use(NamedOrder<typename Traversal::template On<Index, Layout::pre_indexed>>{traversal.name});
    }
    if constexpr (Traversal::walks(Layout::post_indexed)) {
      use(NamedOrder<typename Traversal::template On<Index, Layout::post_indexed>>{traversal.name});
    }
  });
  use(NamedOrder<RankedStack<BasicMesh<Index, Layout::post_indexed>>>{"ranked-stack"});
}

/// For traversals without a stack: their cursors can be kept.
template <class Index, class Use>
void for_each_stackless_order(Use&& use) {
  for_each_order<Index>([&use](auto named) {
    if constexpr (decltype(named)::Traversal::kStackless) {
      use(named);
    }
  });
}

}  // namespace flashbvh::test
