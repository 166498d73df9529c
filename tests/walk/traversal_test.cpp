// Every traversal against every other one and against brute force, on thousands of random trees.
#include <map>
#include <string>
#include <tuple>

#include "flashbvh/detail/bounds/box.hpp"
#include "support/at_roots.hpp"
#include "support/points.hpp"
#include "support/queries.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"
#include "support/walk.hpp"

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

/// All pairs of leaves whose boxes overlap, in order.
Pairs brute_force(const Trees& trees) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < trees.a.nodes.size(); ++i) {
    for (std::uint32_t j = 0; j < trees.b.nodes.size(); ++j) {
      const bake::BuildNode& a = trees.a.nodes[i];
      const bake::BuildNode& b = trees.b.nodes[j];
      if (a.is_leaf() && b.is_leaf() && test::overlap(a.box, b.box, trees.translation)) {
        pairs.emplace_back(i, j);
      }
    }
  }
  return pairs;
}

/// A whole walk. Nodes are named by their indices in the BuildTrees, which no layout changes.
struct Record {
  Pairs visits;
  Pairs leaf_pairs;
  std::uint32_t overlaps = 0;
};

/// A stack gets exactly stack_entries() entries.
template <class Traversal>
Record record(const Baked<Traversal::Tree::kLayout>& a, const Baked<Traversal::Tree::kLayout>& b,
              const TranslatedBoxTest& test) {
  Record record;
  const auto build_pair = [&](std::uint32_t i, std::uint32_t j) {
    return std::make_pair(a.build_nodes[i], b.build_nodes[j]);
  };
  // A box's address tells its node.
  const auto index_in = [](const auto& baked, const PackedBox& box) {
    const auto* const node = reinterpret_cast<const Node<std::uint16_t>*>(&box);
    return static_cast<std::uint32_t>(node - baked.nodes.data());
  };
  const auto bound = [&](const PackedBox& box_a, const PackedBox& box_b) {
    record.visits.push_back(build_pair(index_in(a, box_a), index_in(b, box_b)));
    return test(box_a, box_b);
  };
  const auto leaf_pair = [&](std::uint32_t i, std::uint32_t j, const Progress&) {
    record.leaf_pairs.push_back(build_pair(i, j));
    return true;
  };
  std::vector<PairCursor<std::uint16_t>> entries(stack_entries(a.stack_need, b.stack_need));
  auto cursor = at_roots<Traversal>(entries.data(), static_cast<std::uint32_t>(entries.size()));
  const Walked walked =
      walk_from<Traversal>(a.view(), b.view(), bound, cursor, leaf_pair, 1'000'000);
  REQUIRE(walked.end == State::done);
  record.overlaps = walked.counts.overlaps;
  return record;
}

/// The rule of a traversal: with a stack or without, traversals of one rule visit the same pairs.
std::string rule_of(const std::string& traversal) {
  const std::string rule = traversal.substr(0, traversal.find('-'));
  return rule == "stackless" ? "alternating" : rule;
}

/// Gives the inner nodes any ranks that do not grow from a parent to its child.
void set_any_ranks(Random& random, Baked<Layout::post_indexed>& baked) {
  const Mesh tree = baked.view();
  std::vector<std::int32_t> ranks(baked.nodes.size(), random.between(1, kMaxRank));
  const auto set = [&](std::uint32_t node, std::int32_t of_parent) {
    if (!baked.nodes[node].is_leaf()) {
      baked.nodes[node].data = static_cast<std::uint16_t>(ranks[node] << 8 | of_parent);
    }
  };
  set(0, kRootParentRank);
  for (std::uint32_t parent = 0; parent < baked.nodes.size(); ++parent) {
    if (!baked.nodes[parent].is_leaf()) {
      std::uint32_t child = tree.first_child(parent);
      for (bool is_last = false; !is_last; child = tree.next_sibling(child)) {
        ranks[child] = random.between(random.below(3) == 0 ? ranks[parent] : 1, ranks[parent]);
        set(child, ranks[parent]);
        is_last = tree.is_last_child(parent, child);
      }
    }
  }
}

/// Checks the paper's five traversals and ours on one pair of trees, with any ranks or those of
/// baking.
void check_all(const Trees& trees, Random* ranks = nullptr) {
  constexpr Layout pre = Layout::pre_indexed;
  std::tuple baked_a{baked<pre>(trees.a, trees.mesh_a), baked(trees.a, trees.mesh_a)};
  std::tuple baked_b{baked<pre>(trees.b, trees.mesh_b), baked(trees.b, trees.mesh_b)};
  if (ranks != nullptr) {
    set_any_ranks(*ranks, std::get<1>(baked_a));
    set_any_ranks(*ranks, std::get<1>(baked_b));
  }
  const auto& [x, y, z] = trees.translation;
  const TranslatedBoxTest bound(x, y, z);
  const Pairs truth = brute_force(trees);
  std::map<std::string, Record> of_rules;
  for_each_order<std::uint16_t>([&](auto named) {
    using Traversal = typename decltype(named)::Traversal;
    CAPTURE(named.name, static_cast<int>(Traversal::Tree::kLayout));
    constexpr auto layout = static_cast<std::size_t>(Traversal::Tree::kLayout);
    const Record walk =
        record<Traversal>(std::get<layout>(baked_a), std::get<layout>(baked_b), bound);
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

TEST_CASE("ranked follows its stack under any ranks") {
  for_rounds(rounds(150, 600), 3, [&](Random& random, int) {
    const std::uint32_t count_a = 1 + random.below(30);
    const std::uint32_t count_b = 1 + random.below(30);
    check_all(any_trees(random, count_a, count_b), &random);
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
