// `ranked` under ranks of every kind, not only those of baking: the walk must not depend on the
// ranks' meaning, but only on ranks that never grow from a parent to its child.
#include "support/record.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

using Post = Baked<Layout::post_indexed>;
using Pair = BakedPair<Post>;

struct Trees {
  Pair baked;
  TranslatedBoxTest overlap;
  NodePairs truth;
};

Trees any_trees(Random& random, std::uint32_t most) {
  const auto mesh_a = random_mesh(random, 1 + random.below(most), 40, 30);
  const auto mesh_b = random_mesh(random, 1 + random.below(most), 40, 30);
  const auto a = any_tree(random, mesh_a);
  const auto b = any_tree(random, mesh_b);
  const std::int32_t x = random.between(-30, 30);
  const std::int32_t y = random.between(-30, 30);
  return {bake_pair<Layout::post_indexed>(a, mesh_a, b, mesh_b), TranslatedBoxTest(x, y, 0),
          brute_force(a, b, {x, y, 0})};
}

/// Sets the rank of each internal node to rank_of(node, rank of its parent).
template <class RankOf>
void set_ranks(Post& baked, RankOf rank_of) {
  const auto tree = baked.view();
  std::vector<std::int32_t> ranks(baked.nodes.size(), 0);
  const auto set = [&](std::uint32_t node, std::int32_t parent_rank) {
    if (!baked.nodes[node].is_leaf()) {
      ranks[node] = rank_of(node, parent_rank);
      baked.nodes[node].data = static_cast<std::uint16_t>(ranks[node] << 8 | parent_rank);
    }
  };
  set(0, kRootParentRank);
  for (std::uint32_t parent = 0; parent < baked.nodes.size(); ++parent) {
    if (baked.nodes[parent].is_leaf()) {
      continue;
    }
    for (std::uint32_t child = tree.first_child(parent);; child = tree.next_sibling(child)) {
      set(child, ranks[parent]);
      if (tree.is_last_child(parent, child)) {
        break;
      }
    }
  }
}

/// A rank that does not exceed the parent's.
std::int32_t random_rank(Random& random, std::int32_t parent_rank) {
  const std::int32_t most = parent_rank > kMaxRank ? kMaxRank : parent_rank;
  return random.between(random.below(3) == 0 ? most : 1, most);
}

template <class RanksOfA, class RanksOfB>
void check_ranks(Trees& trees, RanksOfA ranks_of_a, RanksOfB ranks_of_b) {
  set_ranks(trees.baked.a, ranks_of_a);
  set_ranks(trees.baked.b, ranks_of_b);
  const Record ranked = record<Ranked<Mesh>>(trees.baked, trees.overlap);
  const Record stack = record<RankedStack<Mesh>>(trees.baked, trees.overlap);
  REQUIRE(ranked.ended);
  REQUIRE(ranked.visits == stack.visits);
  REQUIRE(ranked.leaf_pairs == stack.leaf_pairs);
  REQUIRE(sorted(ranked.leaf_pairs) == trees.truth);
}

const int kRounds = rounds(75, 300);

}  // namespace

TEST_CASE("ranked follows its stack when all ranks are equal") {
  for_rounds(kRounds, [&](Random& random, int) {
    Trees trees = any_trees(random, 30);
    const std::int32_t same = random.between(1, kMaxRank);
    const auto equal = [&](std::uint32_t, std::int32_t) { return same; };
    check_ranks(trees, equal, equal);
  });
}

TEST_CASE("ranked follows its stack when all ranks along each path are different") {
  for_rounds(kRounds, 1, [&](Random& random, int) {
    Trees trees = any_trees(random, 30);
    // A's ranks are even, B's odd: no rank of one tree occurs in the other.
    const auto falling = [&](std::int32_t odd) {
      return [odd](std::uint32_t, std::int32_t parent_rank) {
        return parent_rank > kMaxRank ? kMaxRank - 2 + odd
               : parent_rank > 3      ? parent_rank - 2
                                      : parent_rank;
      };
    };
    check_ranks(trees, falling(0), falling(1));
  });
}

TEST_CASE("ranked follows its stack under random ranks, and through every pair of the walk") {
  for_rounds(kRounds, 2, [&](Random& random, int round) {
    Trees trees = any_trees(random, round % 3 == 0 ? 12 : 30);
    const auto any = [&](std::uint32_t, std::int32_t parent) {
      return random_rank(random, parent);
    };
    check_ranks(trees, any, any);
    if (round % 3 == 0) {
      PairCursor<std::uint16_t> cursor;
      NodePairs rest = record<Ranked<Mesh>>(trees.baked, trees.overlap).visits;
      for (; !rest.empty(); rest.erase(rest.begin())) {
        PairCursor<std::uint16_t> here = cursor;
        REQUIRE(record_from<Ranked<Mesh>>(trees.baked, trees.overlap, here).visits == rest);
        (void)record_from<Ranked<Mesh>>(trees.baked, trees.overlap, cursor, 1);
      }
    }
  });
}

TEST_CASE("the alternating rule is the special case of ranks that fall with the level") {
  int compared = 0;
  for_rounds(kRounds, 3, [&](Random& random, int) {
    Trees trees = any_trees(random, 30);
    if (trees.baked.a.depth > 60 || trees.baked.b.depth > 60) {
      return;
    }
    // On each level B comes first: its rank lies above A's, and A's above that of B's next level.
    const auto by_level = [](const Post& baked, std::int32_t top) {
      return [&baked, top](std::uint32_t node, std::int32_t) {
        return top - 2 * static_cast<std::int32_t>(baked.levels[node]);
      };
    };
    set_ranks(trees.baked.a, by_level(trees.baked.a, kMaxRank - 1));
    set_ranks(trees.baked.b, by_level(trees.baked.b, kMaxRank));
    const Record ranked = record<Ranked<Mesh>>(trees.baked, trees.overlap);
    const Record alternating = record<AlternatingStackPost>(trees.baked, trees.overlap);
    REQUIRE(ranked.visits == alternating.visits);
    ++compared;
  });
  CHECK(compared > kRounds / 2);
}
