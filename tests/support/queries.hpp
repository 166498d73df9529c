// Runs queries of any traversal to the end, in runs of any length, and brute force.
#pragma once

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "bake/mesh.hpp"
#include "flashbvh/collide.hpp"
#include "heap_guard.hpp"
#include "support/any_query.hpp"
#include "support/transformed_vertex.hpp"

namespace flashbvh::test {

/// Pairs of triangles of A and B, by their numbers in the source.
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

inline Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// All pairs of triangles that intersect, in order, of meshes before baking.
inline Pairs brute_force(const bake::LatticeMesh& a, const bake::LatticeMesh& b, const Pose& pose) {
  Pairs pairs;
  brute_force(a, static_cast<std::uint32_t>(a.triangles.size()), b,
              static_cast<std::uint32_t>(b.triangles.size()), pose,
              [&pairs](std::uint32_t i, std::uint32_t j) { pairs.emplace_back(i, j); });
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

/// Checks the pairs of each traversal that supports this layout, NearFirst included. `truth`: in
/// order.
template <class Tree>
void check_pairs(const Tree& a, const Tree& b, const Pose& pose, const Pairs& truth) {
  for_each_query(a, b, pose, [&truth](const char* name, auto& query) {
    CAPTURE(name);
    REQUIRE(sorted(run_to_end(query)) == truth);
    REQUIRE(query.stats().triangle_pairs == truth.size());
  });
  if constexpr (Tree::kLayout == Layout::post_indexed) {
    using Near = Query<detail::NearFirst<BasicMesh<typename Tree::Index, Tree::kLayout>>>;
    Near whole(a, b, pose);
    REQUIRE(sorted(run_to_end(whole)) == truth);
    Near cut(a, b, pose);
    REQUIRE(sorted(run_to_end(cut, 33, 2)) == truth);
  }
}

}  // namespace flashbvh::test
