// The traversal of a search for one pair on wide trees.
#include "flashbvh/collide.hpp"
#include "support/any_mesh.hpp"
#include "support/rotations.hpp"
#include "support/test.hpp"
#include "support/torus.hpp"

namespace {

using Near = Query<detail::NearFirst<Mesh>>;

/// The number of pairs, which are those of ranked, whole and cut into runs.
template <class MeshType>
std::size_t check_pairs(Random& random, const MeshType& a, const MeshType& b, const Pose& pose) {
  const auto pairs_of = [&](auto&& query, std::uint32_t work, std::uint32_t capacity) {
    return sorted(run_to_end(query, work, capacity));
  };
  using NearQuery = Query<detail::NearFirst<MeshType>>;
  const Pairs pairs = pairs_of(Query<Ranked<MeshType>>(a, b, pose), kNoLimit, 1000);
  REQUIRE(pairs_of(NearQuery(a, b, pose), kNoLimit, 1000) == pairs);
  const std::uint32_t work = 1 + random.below(3000);
  const std::uint32_t capacity = 1 + random.below(7);
  REQUIRE(pairs_of(NearQuery(a, b, pose), work, capacity) == pairs);
  return pairs.size();
}

}  // namespace

TEST_CASE("nearest first, a query has the pairs of ranked where nodes have 2 to 9 children") {
  const bake::LatticeMesh ring = torus(24, 12, 900, 300);
  for_rounds(8u, 1, [&](Random& random, std::uint32_t round) {
    const bake::BuildTree tree = bake::collapse(bake::build_sah(ring, 2), 2 + round);
    const auto narrow = baked(tree, ring);
    const auto wide = bake::lay_out<std::uint32_t, Layout::post_indexed>(tree, ring);
    for (int i = 0; i < 6; ++i) {
      const Pose pose = any_rigid_pose(random, 700);
      const std::size_t pairs = check_pairs<Mesh>(random, narrow.view(), narrow.view(), pose);
      REQUIRE(check_pairs<Mesh32>(random, wide.view(), wide.view(), pose) == pairs);
    }
  });
}

TEST_CASE("as ranked, a walk is ranked's") {
  for_rounds(200, 4, [&](Random& random, int) {
    const Scene scene = any_scene(random);
    PairQuery ranked(scene.a, scene.b, scene.pose);
    Near near(scene.a, scene.b, scene.pose, detail::NearFirst<Mesh>::as_ranked());
    REQUIRE(run_to_end(near) == run_to_end(ranked));
    REQUIRE(near.stats().visits == ranked.stats().visits);
  });
}
