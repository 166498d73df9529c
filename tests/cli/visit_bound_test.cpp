// The bound on visits against walks in which all boxes overlap, on trees of every form.
#include "bake/baked_tree.hpp"
#include "evaluate/needed_work.hpp"
#include "flashbvh/traversal/traversals.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"
#include "support/walk.hpp"

using namespace flashbvh::detail;

namespace {

using Post = bake::BakedTree<std::uint16_t, Layout::post_indexed>;

Post any_baked(Random& random) {
  const bake::LatticeMesh mesh = random_mesh(random, 1 + random.below(24), 30, 25);
  return bake::lay_out<std::uint16_t, Layout::post_indexed>(any_tree(random, mesh), mesh);
}

struct Visited {
  std::uint64_t visits = 0;
  std::uint64_t leaf_pairs = 0;
};

template <class Traversal, class Tree>
Visited walk_all(const Tree& a, const Tree& b) {
  typename Traversal::Cursor cursor;
  Visited walked;
  const auto always = [](const PackedBox&, const PackedBox&) { return true; };
  const auto leaf_pair = [&walked](std::uint32_t, std::uint32_t, const detail::Progress&) {
    ++walked.leaf_pairs;
    return true;
  };
  walked.visits = test::walk_from<Traversal>(a, b, always, cursor, leaf_pair).counts.visits;
  return walked;
}

}  // namespace

TEST_CASE("ranked visits exactly its bound when all boxes overlap") {
  for_rounds(rounds(600, 2000), [&](Random& random, int) {
    const Post baked_a = any_baked(random);
    const Post baked_b = any_baked(random);
    const MeshWithLevels a = baked_a.view();
    const MeshWithLevels b = baked_b.view();
    const Visited ranked = walk_all<Ranked<Mesh>, Mesh>(a, b);
    const tool::VisitBound bound = tool::visit_bound(a, b, "ranked");
    REQUIRE(ranked.visits == bound.visits);
    REQUIRE(ranked.leaf_pairs == bound.leaf_pairs);
    const tool::VisitBound of_any = tool::visit_bound(a, b, "leaf");
    REQUIRE(ranked.visits <= of_any.visits);
    REQUIRE(walk_all<LeafPost, Mesh>(a, b).visits <= of_any.visits);
    REQUIRE(walk_all<StacklessPost, MeshWithLevels>(a, b).visits <= of_any.visits);
  });
}
