// Queries run to their end, in runs of any length, for every traversal alike.
#ifndef FLASHBVH_TESTS_SUPPORT_QUERIES_HPP
#define FLASHBVH_TESTS_SUPPORT_QUERIES_HPP

#include <catch2/catch.hpp>

#include <cstdint>
#include <utility>
#include <vector>

#include "flashbvh/query.hpp"
#include "heap_guard.hpp"
#include "support/record.hpp"

namespace flashbvh::test {

/// Triangles of A and B, by their numbers in the source.
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

constexpr std::uint32_t kNoLimit = 0xFFFFFFFFu;

/// All pairs in the order reported, in runs of `visits` into an array of `capacity`.
template <class Query>
Pairs run_to_end(Query& query, std::uint32_t visits, std::uint32_t capacity) {
  std::vector<typename Query::Pair> found(capacity);
  Pairs pairs;
  pairs.reserve(10000);
  for (;;) {
    Step step{};
    {
      const HeapForbidden guard;
      step = query.run(visits, found.data(), capacity);
    }
    for (std::uint32_t i = 0; i < step.count; ++i) {
      pairs.emplace_back(found[i].a, found[i].b);
    }
    if (step.status == Status::done) {
      return pairs;
    }
    REQUIRE((step.status == Status::suspended || step.status == Status::full));
    REQUIRE((step.status != Status::full || step.count == capacity));
  }
}

/// A query of this traversal on its own array, if it needs one. Scene: has trees a, b and a pose.
template <class Traversal>
struct AnyQuery {
  using Tree = typename Traversal::Tree;
  Tree a, b;
  Query<Traversal> query;

  template <class Scene>
  explicit AnyQuery(const Scene& scene)
      : a(scene.a.view()), b(scene.b.view()), query(a, b, scene.pose) {}
};

template <class Traversal>
struct StackQuery {
  using Tree = typename Traversal::Tree;
  Tree a, b;
  std::vector<detail::PairCursor<std::uint16_t>> entries;
  Query<Traversal> query;

  template <class Scene>
  explicit StackQuery(const Scene& scene)
      : a(scene.a.view()),
        b(scene.b.view()),
        entries(stack_entries(a.stack_need, b.stack_need)),
        query(a, b, scene.pose, {entries.data(), static_cast<std::uint32_t>(entries.size())}) {}
};

template <class Tree, class Rule>
struct AnyQuery<StackOrder<Tree, Rule>> : StackQuery<StackOrder<Tree, Rule>> {
  using StackQuery<StackOrder<Tree, Rule>>::StackQuery;
};

template <class Tree>
struct AnyQuery<RankedStack<Tree>> : StackQuery<RankedStack<Tree>> {
  using StackQuery<RankedStack<Tree>>::StackQuery;
};

}  // namespace flashbvh::test

#endif
