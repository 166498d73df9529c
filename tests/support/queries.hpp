// Runs queries of any traversal to the end, in runs of any length.
#pragma once

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "heap_guard.hpp"
#include "support/any_query.hpp"

namespace flashbvh::test {

/// Pairs of triangles of A and B, by their numbers in the source.
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

inline Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

constexpr std::uint32_t kNoLimit = 0xFFFFFFFFu;

/// All pairs in the order of reporting, from runs of `work` into an array of `capacity`.
template <class Query>
Pairs run_to_end(Query& query, std::uint32_t work = kNoLimit, std::uint32_t capacity = 1000) {
  std::vector<typename Query::Pair> found(capacity);
  Pairs pairs;
  pairs.reserve(10000);
  for (;;) {
    RunResult step{};
    {
      const HeapForbidden guard;
      step = query.run(work, found.data(), capacity);
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

/// Checks the pairs of each traversal that supports this layout. `truth`: in order.
template <class Tree>
void check_pairs(const Tree& a, const Tree& b, const Pose& pose, const Pairs& truth) {
  for_each_query(a, b, pose, [&truth](const char* name, auto& query) {
    CAPTURE(name);
    REQUIRE(sorted(run_to_end(query)) == truth);
    REQUIRE(query.stats().triangle_pairs == truth.size());
  });
}

}  // namespace flashbvh::test
