// Every traversal against every other one and against brute force, on thousands of random trees.
#include <map>
#include <string>
#include <tuple>

#include "support/record.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

struct Trees {
  bake::LatticeMesh mesh_a, mesh_b;
  bake::BuildTree a, b;
  Point translation;  ///< B's
};

Trees any_trees(Random& random, std::uint32_t count_a, std::uint32_t count_b) {
  const std::int32_t spread = random.below(2) == 0 ? 20 : 300;
  Trees trees{random_mesh(random, count_a, spread, 30),
              random_mesh(random, count_b, spread, 30),
              {},
              {},
              {0, 0, 0}};
  trees.a = any_tree(random, trees.mesh_a);
  trees.b = any_tree(random, trees.mesh_b);
  if (random.below(3) != 0) {
    trees.translation = any_point(random, random.between(1, 2 * spread));
  }
  return trees;
}

/// The rule of a traversal: with a stack or without, traversals of one rule visit the same pairs.
std::string rule_of(const std::string& traversal) {
  const std::string rule = traversal.substr(0, traversal.find('-'));
  return rule == "stackless" ? "alternating" : rule;
}

/// Checks the paper's five traversals and ours on one pair of trees.
void check_all(const Trees& trees) {
  const std::tuple pairs{
      bake_pair<Layout::pre_indexed>(trees.a, trees.mesh_a, trees.b, trees.mesh_b),
      bake_pair<Layout::post_indexed>(trees.a, trees.mesh_a, trees.b, trees.mesh_b)};
  const auto& [x, y, z] = trees.translation;
  const TranslatedBoxTest bound(x, y, z);
  const NodePairs truth = brute_force(trees.a, trees.b, trees.translation);
  std::map<std::string, Record> of_rules;
  for_each_order<std::uint16_t>([&](auto named) {
    using Traversal = typename decltype(named)::Traversal;
    CAPTURE(named.name, static_cast<int>(Traversal::Tree::kLayout));
    const auto& pair = std::get<static_cast<std::size_t>(Traversal::Tree::kLayout)>(pairs);
    const Record walk = record<Traversal>(pair, bound);
    REQUIRE(walk.ended);
    REQUIRE(sorted(walk.leaf_pairs) == truth);
    const Record& first = of_rules.emplace(rule_of(named.name), walk).first->second;
    REQUIRE(walk.visits == first.visits);
    REQUIRE(walk.leaf_pairs == first.leaf_pairs);
    REQUIRE(walk.overlaps == first.overlaps);
  });
}

}  // namespace

TEST_CASE("all traversals agree on all pairs of sizes 1 to 8, over random shapes") {
  Random random = test_random();
  for (std::uint32_t a = 1; a <= 8; ++a) {
    for (std::uint32_t b = 1; b <= 8; ++b) {
      for (int round = 0; round < rounds(8, 40); ++round) {
        CAPTURE(a, b, round);
        check_all(any_trees(random, a, b));
      }
    }
  }
}

TEST_CASE("all traversals agree on random trees of every shape") {
  for_rounds(rounds(100, 600), 1, [&](Random& random, int) {
    const std::uint32_t count_a = 1 + random.below(60);
    const std::uint32_t count_b = 1 + random.below(60);
    check_all(any_trees(random, count_a, count_b));
  });
}

TEST_CASE("all traversals agree on the trees of each builder, and find what brute force finds") {
  Random random = test_random(5);
  using Builder = bake::BuildTree (*)(const bake::LatticeMesh&);
  const Builder builders[] = {
      [](const bake::LatticeMesh& mesh) { return bake::build_default(mesh); },
      [](const bake::LatticeMesh& mesh) { return bake::build_sah(mesh, 1); },
      [](const bake::LatticeMesh& mesh) { return bake::collapse(bake::build_sah(mesh, 3), 8); },
      [](const bake::LatticeMesh& mesh) { return bake::build_median(mesh, 1); },
  };
  for (const Builder& build_a : builders) {
    for (const Builder& build_b : builders) {
      for (int round = 0; round < rounds(4, 30); ++round) {
        CAPTURE(&build_a - builders, &build_b - builders, round);
        const std::uint32_t count_a = 1 + random.below(90);
        const std::uint32_t count_b = 1 + random.below(90);
        Trees trees = any_trees(random, count_a, count_b);
        trees.a = build_a(trees.mesh_a);
        trees.b = build_b(trees.mesh_b);
        check_all(trees);
      }
    }
  }
}

TEST_CASE("all traversals agree on chains as deep as their triangles, and on unequal heights") {
  for_rounds(12, 2, [&](Random& random, int round) {
    const std::uint32_t count_a = 1 + random.below(120);
    const std::uint32_t count_b = 1 + random.below(120);
    Trees trees = any_trees(random, count_a, count_b);
    trees.a = chain(trees.mesh_a, (round & 1) != 0);
    if ((round & 2) != 0) {
      trees.b = chain(trees.mesh_b, (round & 4) != 0);
    }
    check_all(trees);
    std::swap(trees.a, trees.b);
    std::swap(trees.mesh_a, trees.mesh_b);
    check_all(trees);
  });
}

TEST_CASE("all traversals agree when everything overlaps, and when nothing does") {
  Random random = test_random(3);
  Trees trees = any_trees(random, 40, 40);
  trees.translation = {0, 0, 0};
  for (bake::BuildNode& node : trees.a.nodes) {
    node.box = {{-16383, -16383, -16383}, {16383, 16383, 16383}};
  }
  trees.b = chain(trees.mesh_b, true);
  check_all(trees);
  trees.translation.x = 100000;
  check_all(trees);
}
