// The traversal of a search for one pair, as ranked. Its pairs: support/queries.hpp.
#include "flashbvh/collide.hpp"
#include "support/any_mesh.hpp"
#include "support/test.hpp"

TEST_CASE("as ranked, a walk is ranked's") {
  for_rounds(200, 4, [&](Random& random, int) {
    const Scene scene = any_scene(random);
    PairQuery ranked(scene.a, scene.b, scene.pose);
    Query<detail::NearFirst<Mesh>> near(scene.a, scene.b, scene.pose,
                                        detail::NearFirst<Mesh>::as_ranked());
    REQUIRE(run_to_end(near) == run_to_end(ranked));
    REQUIRE(near.stats().visits == ranked.stats().visits);
  });
}

TEST_CASE("with 32-bit indices a query finds exactly the pairs that brute force finds") {
  for_rounds(40, 5, [&](Random& random, int) {
    const bake::LatticeMesh a = random_mesh(random, 16, 25, 25);
    const bake::LatticeMesh b = random_mesh(random, 16, 25, 25);
    const auto wide_a = bake::lay_out<std::uint32_t, Layout::post_indexed>(any_tree(random, a), a);
    const auto wide_b = bake::lay_out<std::uint32_t, Layout::post_indexed>(any_tree(random, b), b);
    const Pose pose = any_pose(random, 15);
    check_pairs(wide_a.view(), wide_b.view(), pose, brute_force(a, b, pose));
  });
}
