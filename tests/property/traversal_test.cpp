// Every traversal against every other and against brute force, on thousands of random trees.
#include <catch2/catch.hpp>

#include "support/record.hpp"
#include "support/shapes.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

struct Trees {
  bake::LatticeMesh mesh_a, mesh_b;
  bake::BuildTree a, b;
  std::int32_t x, y, z;  ///< B's translation

  TranslatedBound overlap() const { return {x, y, z}; }
  NodePairs brute_force() const { return test::brute_force(a, b, x, y, z); }
};

Trees any_trees(Random& random, std::uint32_t count_a, std::uint32_t count_b) {
  const std::int32_t spread = random.below(2) == 0 ? 20 : 300;
  Trees trees{random_mesh(random, count_a, spread, 30),
              random_mesh(random, count_b, spread, 30),
              {},
              {},
              0,
              0,
              0};
  trees.a = any_tree(random, trees.mesh_a);
  trees.b = any_tree(random, trees.mesh_b);
  const std::int32_t reach = random.below(3) == 0 ? 0 : random.between(1, 2 * spread);
  trees.x = random.between(-reach, reach);
  trees.y = random.between(-reach, reach);
  trees.z = random.between(-reach, reach);
  return trees;
}

/// The five traversals of the paper, and ours, on one pair of trees. False says which rule broke.
void check_all(const Trees& trees) {
  const auto pre = bake_pair<Layout::pre_indexed>(trees.a, trees.mesh_a, trees.b, trees.mesh_b);
  const auto post = bake_pair<Layout::post_indexed>(trees.a, trees.mesh_a, trees.b, trees.mesh_b);
  const TranslatedBound overlap = trees.overlap();
  const NodePairs truth = trees.brute_force();

  const Record stackless = record_stackless<Stackless>(pre, overlap);
  const Record stackless_post = record_stackless<StacklessPost>(post, overlap);
  const Record alternating = record_stack<AlternatingStack<LevelledPreMesh>>(pre, overlap);
  const Record alternating_post = record_stack<AlternatingStack<LevelledPostMesh>>(post, overlap);
  REQUIRE(alternating.ended);
  REQUIRE(stackless.visits == alternating.visits);
  REQUIRE(stackless_post.visits == alternating.visits);
  REQUIRE(alternating_post.visits == alternating.visits);
  REQUIRE(stackless.leaf_pairs == alternating.leaf_pairs);
  REQUIRE(stackless_post.leaf_pairs == alternating.leaf_pairs);
  REQUIRE(alternating.sorted_leaf_pairs() == truth);

  const Record volume = record_stack<VolumeStack<PreMesh>>(pre, overlap);
  const Record volume_post = record_stack<VolumeStack<PostMesh>>(post, overlap);
  REQUIRE(volume.visits == volume_post.visits);
  REQUIRE(volume.sorted_leaf_pairs() == truth);

  const Record leaf = record_stackless<Leaf<PreMesh>>(pre, overlap);
  const Record leaf_post = record_stackless<Leaf<PostMesh>>(post, overlap);
  REQUIRE(leaf.visits == leaf_post.visits);
  REQUIRE(leaf.sorted_leaf_pairs() == truth);

  const Record ranked = record_stackless<Ranked<PostMesh>>(post, overlap);
  const Record ranked_stack = record_stack<RankedStack<PostMesh>>(post, overlap);
  REQUIRE(ranked.visits == ranked_stack.visits);
  REQUIRE(ranked.leaf_pairs == ranked_stack.leaf_pairs);
  REQUIRE(ranked.overlaps == ranked_stack.overlaps);
  REQUIRE(ranked.sorted_leaf_pairs() == truth);
  REQUIRE(ranked.ended);
}

}  // namespace

TEST_CASE("all traversals agree on all pairs of sizes 1 to 8, over random shapes") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed);
  for (std::uint32_t a = 1; a <= 8; ++a) {
    for (std::uint32_t b = 1; b <= 8; ++b) {
      for (int round = 0; round < 40; ++round) {
        CAPTURE(a, b, round);
        check_all(any_trees(random, a, b));
      }
    }
  }
}

TEST_CASE("all traversals agree on random trees of every shape") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 1);
  for (int round = 0; round < 600; ++round) {
    CAPTURE(round);
    check_all(any_trees(random, 1 + random.below(60), 1 + random.below(60)));
  }
}

TEST_CASE("all traversals agree on the trees of each builder, and find what brute force finds") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 5);
  using Builder = bake::BuildTree (*)(const bake::LatticeMesh&);
  const Builder builders[] = {
      bake::build_default,
      [](const bake::LatticeMesh& mesh) { return bake::build_sah(mesh, 1); },
      [](const bake::LatticeMesh& mesh) { return bake::collapse(bake::build_sah(mesh, 3), 8); },
      [](const bake::LatticeMesh& mesh) { return bake::build_median(mesh, 1); },
  };
  for (const Builder& build_a : builders) {
    for (const Builder& build_b : builders) {
      for (int round = 0; round < 30; ++round) {
        CAPTURE(&build_a - builders, &build_b - builders, round);
        Trees trees = any_trees(random, 1 + random.below(90), 1 + random.below(90));
        trees.a = build_a(trees.mesh_a);
        trees.b = build_b(trees.mesh_b);
        check_all(trees);
      }
    }
  }
}

TEST_CASE("all traversals agree on chains as deep as their triangles, and on unequal heights") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 2);
  for (int round = 0; round < 12; ++round) {
    CAPTURE(round);
    Trees trees = any_trees(random, 1 + random.below(120), 1 + random.below(120));
    trees.a = chain(trees.mesh_a, (round & 1) != 0);
    if ((round & 2) != 0) {
      trees.b = chain(trees.mesh_b, (round & 4) != 0);
    }
    check_all(trees);
    std::swap(trees.a, trees.b);
    std::swap(trees.mesh_a, trees.mesh_b);
    check_all(trees);
  }
}

TEST_CASE("all traversals agree when everything overlaps, and when nothing does") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 3);
  Trees trees = any_trees(random, 40, 40);
  trees.x = trees.y = trees.z = 0;
  for (bake::BuildNode& node : trees.a.nodes) {
    node.box = {{-16383, -16383, -16383}, {16383, 16383, 16383}};
  }
  trees.b = chain(trees.mesh_b, true);
  check_all(trees);
  trees.x = 100000;
  check_all(trees);
}

TEST_CASE("the walk that starts at any pair goes on as the one that came there") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 4);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    const Trees trees = any_trees(random, 1 + random.below(12), 1 + random.below(12));
    const auto post = bake_pair<Layout::post_indexed>(trees.a, trees.mesh_a, trees.b, trees.mesh_b);
    const TranslatedBound overlap = trees.overlap();
    PairCursor<std::uint16_t> cursor;
    NodePairs rest = record_stackless<Ranked<PostMesh>>(post, overlap).visits;
    while (!rest.empty()) {
      PairCursor<std::uint16_t> here = cursor;
      REQUIRE(record_from<Ranked<PostMesh>>(post, overlap, here).visits == rest);
      (void)record_from<Ranked<PostMesh>>(post, overlap, cursor, 1);
      rest.erase(rest.begin());
    }
  }
}
