// A query in any traversal, with a stack array of exactly the required size; one of each traversal.
#pragma once

#include <cstdint>
#include <vector>

#include "flashbvh/query.hpp"
#include "support/at_roots.hpp"
#include "support/compiled_queries.hpp"

namespace flashbvh::test {

template <class Traversal>
struct AnyQuery {
  using Tree = typename Traversal::Tree;
  Tree a, b;
  std::vector<detail::PairCursor<typename Tree::Index>> entries;
  Query<Traversal> query;

  AnyQuery(const Tree& tree_a, const Tree& tree_b, const Pose& pose)
      : a(tree_a),
        b(tree_b),
        entries(stack_entries(a.stack_need, b.stack_need)),
        query(a, b, pose,
              at_roots<Traversal>(entries.data(), static_cast<std::uint32_t>(entries.size()))) {}
};

/// Calls use(name, any.query) for each traversal that supports this layout.
template <class Tree, class Use>
void for_each_query(const Tree& a, const Tree& b, const Pose& pose, Use use) {
  for_each_order<typename Tree::Index>([&](auto named) {
    using Traversal = typename decltype(named)::Traversal;
    if constexpr (Traversal::Tree::kLayout == Tree::kLayout) {
      AnyQuery<Traversal> any(a, b, pose);
      use(named.name, any.query);
    }
  });
}

}  // namespace flashbvh::test
