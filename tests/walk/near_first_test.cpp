// The traversal of a search for one pair on trees of any form, and its savings.
#include "flashbvh/collide.hpp"
#include "support/any_mesh.hpp"
#include "support/rotations.hpp"
#include "support/test.hpp"
#include "support/torus.hpp"

namespace {

using Near = Query<detail::NearFirst<Mesh>>;
using Near32 = Query<detail::NearFirst<Mesh32>>;

template <class Query, class MeshType>
Pairs sorted_pairs(const MeshType& a, const MeshType& b, const Pose& pose, std::uint32_t work,
                   std::uint32_t capacity) {
  Query query(a, b, pose);
  Pairs pairs = run_to_end(query, work, capacity);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

TEST_CASE("nearest first, a query has the pairs of ranked, on trees of any shape") {
  Random random = test_random();
  std::size_t total = 0;
  for (int round = 0; round < 400; ++round) {
    CAPTURE(round);
    const Scene scene = any_scene(random);
    const Mesh a = scene.a.view<Mesh>();
    const Mesh b = scene.b.view<Mesh>();
    const Pairs pairs = sorted_pairs<PairQuery>(a, b, scene.pose, kNoLimit, 100);
    REQUIRE(sorted_pairs<Near>(a, b, scene.pose, kNoLimit, 100) == pairs);
    REQUIRE(sorted_pairs<Near>(a, b, scene.pose, 1 + random.below(80), 1 + random.below(3)) ==
            pairs);
    total += pairs.size();
  }
  CHECK(total > 1000);
}

TEST_CASE("nearest first, a query has the pairs of ranked where nodes have 2 to 9 children") {
  Random random = test_random(1);
  const bake::LatticeMesh ring = torus(24, 12, 900, 300);
  for (std::uint32_t arity = 2; arity < 10; ++arity) {
    CAPTURE(arity);
    const bake::BuildTree tree = bake::collapse(bake::build_sah(ring, 2), arity);
    const auto baked = bake::lay_out<std::uint16_t, Layout::post_indexed>(tree, ring);
    const auto wide = bake::lay_out<std::uint32_t, Layout::post_indexed>(tree, ring);
    for (int i = 0; i < 6; ++i) {
      const Pose pose = any_rigid_pose(random, 700);
      const Pairs pairs =
          sorted_pairs<PairQuery>(Mesh(baked.view()), Mesh(baked.view()), pose, kNoLimit, 5000);
      REQUIRE(sorted_pairs<Near>(Mesh(baked.view()), Mesh(baked.view()), pose, kNoLimit, 5000) ==
              pairs);
      REQUIRE(sorted_pairs<Near32>(Mesh32(wide.view()), Mesh32(wide.view()), pose, 1000, 7) ==
              pairs);
    }
  }
}

TEST_CASE("nearest first, a query has the pairs of ranked on chains of hundreds of levels") {
  Random random = test_random(3);
  for (const bool leaf_first : {false, true}) {
    CAPTURE(leaf_first);
    const bake::LatticeMesh ring = torus(16, 10, 900, 300);
    const auto baked =
        bake::lay_out<std::uint16_t, Layout::post_indexed>(chain(ring, leaf_first), ring);
    const Mesh mesh = baked.view();
    for (int i = 0; i < 4; ++i) {
      const Pose pose = any_rigid_pose(random, 500);
      const Pairs pairs = sorted_pairs<PairQuery>(mesh, mesh, pose, kNoLimit, 5000);
      REQUIRE(sorted_pairs<Near>(mesh, mesh, pose, kNoLimit, 5000) == pairs);
      REQUIRE(sorted_pairs<Near>(mesh, mesh, pose, 3000, 5) == pairs);
      REQUIRE_FALSE(pairs.empty());
    }
  }
}

TEST_CASE("as ranked, a walk is ranked's") {
  Random random = test_random(4);
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    const Scene scene = any_scene(random);
    const Mesh a = scene.a.view<Mesh>();
    const Mesh b = scene.b.view<Mesh>();
    PairQuery ranked(a, b, scene.pose);
    Near near(a, b, scene.pose, detail::NearFirst<Mesh>::as_ranked());
    REQUIRE(run_to_end(near, kNoLimit, 100) == run_to_end(ranked, kNoLimit, 100));
    REQUIRE(near.stats().visits == ranked.stats().visits);
  }
}

TEST_CASE("nearest first, a rotated pair is found after half of the visits") {
  Random random = test_random(2);
  const bake::LatticeMesh ring = torus(40, 20, 900, 300);
  const auto baked =
      bake::lay_out<std::uint16_t, Layout::post_indexed>(bake::build_default(ring), ring);
  const Mesh mesh = baked.view();
  std::uint64_t near_visits = 0;
  std::uint64_t ranked_visits = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose pose = any_rigid_pose(random, 900);
    TrianglePair<std::uint16_t> found[1];
    Near near(mesh, mesh, pose);
    PairQuery ranked(mesh, mesh, pose);
    const Status status = near.run(kNoLimit, found).status;
    REQUIRE(ranked.run(kNoLimit, found).status == status);
    if (status == Status::full) {
      near_visits += near.stats().visits;
      ranked_visits += ranked.stats().visits;
    }
  }
  CHECK(near_visits * 2 < ranked_visits);
  CHECK(near_visits > 0);
}
