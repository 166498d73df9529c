// Queries the output for C and C++ like firmware, and prints the pairs as `flashbvh collide
// --pairs` does.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "_2nd_ring.fbvh.h"
#include "early.fbvh.h"
#include "flashbvh/query.hpp"
#include "flashbvh/traversal/levels.hpp"
#include "flashbvh/traversal/stackless.hpp"
#include "grouped.fbvh.h"
#include "levels.fbvh.h"
#include "ring.fbvh.h"
#include "wide.fbvh.h"

static_assert(ring_TRIANGLE_COUNT == 400 && ring_NODE_COUNT < 799, "a binary tree has 799");
static_assert(ring_IMAGE_BYTES < 50 * ring_TRIANGLE_COUNT, "the budget, everything included");
static_assert(grouped_IMAGE_BYTES < ring_IMAGE_BYTES, "fewer leaves, fewer bytes");
static_assert(early_DEPTH == ring_DEPTH && wide_NODE_COUNT == ring_NODE_COUNT, "");
static_assert(ring_CELL > 0.124 && ring_CELL < 0.126, "");
static_assert(ring_CELLS_PER_UNIT == 8.0f, "");

namespace {

using Pairs = std::vector<std::pair<unsigned, unsigned>>;

template <class Traversal>
Pairs pairs_of(const typename Traversal::Tree& a, const typename Traversal::Tree& b) {
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
  using namespace flashbvh;
  const auto ring = view_unchecked<Mesh>(ring_image);
  const auto grouped = view_unchecked<Mesh>(grouped_image);
  const auto wide = view_unchecked<Mesh32>(wide_image);
  const auto early = view_unchecked<PreMeshWithLevels>(early_image);
  const auto levels = view_unchecked<MeshWithLevels>(levels_image);
  const Pairs pairs = pairs_of<Ranked<Mesh>>(ring, view_unchecked<Mesh>(_2nd_ring_image));
  const bool equal = pairs == pairs_of<Ranked<Mesh>>(grouped, ring) &&
                     pairs == pairs_of<StacklessPost>(levels, levels) &&
                     pairs == pairs_of<Stackless>(early, early) &&
                     pairs == pairs_of<Ranked<Mesh32>>(wide, wide);
  for (const auto& pair : pairs) {
    std::printf("0 %u %u\n", pair.first, pair.second);
  }
  return equal && !pairs.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}
