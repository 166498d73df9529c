// Queries the C++ output as firmware does, and prints what `flashbvh collide --pairs` prints.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "_2nd_ring.fbvh.hpp"
#include "early.fbvh.hpp"
#include "flashbvh/query.hpp"
#include "grouped.fbvh.hpp"
#include "reference/stackless.hpp"
#include "ring.fbvh.hpp"
#include "wide.fbvh.hpp"

static_assert(ring::kTriangleCount == 400 && ring::kNodeCount < 799, "a binary tree has 799");
static_assert(ring::kFlashBytes < 50 * ring::kTriangleCount, "the budget, everything included");
static_assert(grouped::kFlashBytes < ring::kFlashBytes, "fewer leaves, fewer bytes");
static_assert(early::kDepth == ring::kDepth && wide::kNodeCount == ring::kNodeCount, "");
static_assert(ring::kCell > 0.124 && ring::kCell < 0.126, "");
static_assert(ring::kCellsPerUnit == 8.0f, "");

namespace {

using Pairs = std::vector<std::pair<unsigned, unsigned>>;

template <class Traversal>
Pairs ask(const typename Traversal::Tree& a, const typename Traversal::Tree& b) {
  const flashbvh::Pose pose = flashbvh::Pose::translated(48, 16, 8);
  flashbvh::Query<Traversal> query(a, b, pose);
  Pairs pairs;
  const auto status = query
                          .run(0xFFFFFFFFu,
                               [&](const typename decltype(query)::Pair& pair) {
                                 pairs.push_back({pair.a, pair.b});
                                 return true;
                               })
                          .status;
  std::sort(pairs.begin(), pairs.end());
  return status == flashbvh::Status::done ? pairs : Pairs();
}

}  // namespace

int main() {
  using flashbvh::Ranked;
  const Pairs pairs = ask<Ranked<flashbvh::Mesh>>(ring::mesh, _2nd_ring::mesh);
  const bool equal =
      pairs == ask<Ranked<flashbvh::Mesh>>(grouped::mesh, ring::mesh) &&
      pairs == ask<flashbvh::StacklessPost>(ring::levelled_mesh, grouped::levelled_mesh) &&
      pairs == ask<flashbvh::Stackless>(early::levelled_mesh, early::levelled_mesh) &&
      pairs == ask<Ranked<flashbvh::Mesh32>>(wide::mesh, wide::mesh);
  for (const auto& pair : pairs) {
    std::printf("0 %u %u\n", pair.first, pair.second);
  }
  return equal && !pairs.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}
