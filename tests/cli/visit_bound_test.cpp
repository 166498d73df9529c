// The bound on visits against walks in which all boxes overlap, on trees of every form.
#include "bake/baked_tree.hpp"
#include "evaluate/needed_work.hpp"
#include "flashbvh/traversal/traversals.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"
#include "support/walk.hpp"

using namespace flashbvh::detail;

namespace {

struct Both {
  Baked<Layout::post_indexed> post;
  Baked<Layout::pre_indexed> pre;
};

Both any_baked(Random& random) {
  const bake::LatticeMesh mesh = random_mesh(random, 1 + random.below(24), 30, 25);
  const bake::BuildTree tree = any_tree(random, mesh);
  return {baked(tree, mesh), baked<Layout::pre_indexed>(tree, mesh)};
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

TEST_CASE("ranked visits exactly its bound when all boxes overlap, stackless no more") {
  for_rounds(rounds(600, 2000), [&](Random& random, int) {
    const Both baked_a = any_baked(random);
    const Both baked_b = any_baked(random);
    const MeshWithLevels a = baked_a.post.view();
    const MeshWithLevels b = baked_b.post.view();
    const Visited ranked = walk_all<Ranked<Mesh>, Mesh>(a, b);
    const tool::VisitBound bound = tool::visit_bound(a, b);
    REQUIRE(ranked.visits == bound.visits);
    REQUIRE(ranked.leaf_pairs == bound.leaf_pairs);
    const PreMeshWithLevels pre_a = baked_a.pre.view();
    const PreMeshWithLevels pre_b = baked_b.pre.view();
    const Visited stackless = walk_all<Stackless, PreMeshWithLevels>(pre_a, pre_b);
    REQUIRE(stackless.visits <= tool::visit_bound(pre_a, pre_b).visits);
  });
}
