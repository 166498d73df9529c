// Queries under rotation: every traversal and layout against brute force over placed triangles.
#include <catch2/catch.hpp>

#include <algorithm>

#include "flashbvh/traversal/alternating_stack.hpp"
#include "flashbvh/traversal/leaf.hpp"
#include "flashbvh/traversal/ranked_stack.hpp"
#include "flashbvh/traversal/stackless.hpp"
#include "flashbvh/traversal/stackless_post.hpp"
#include "flashbvh/traversal/volume_stack.hpp"
#include "support/placed_mesh.hpp"
#include "support/queries.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

template <Layout layout>
struct Scene {
  bake::LatticeMesh mesh_a, mesh_b;
  Baked<layout> a, b;
  Pose pose;

  Pairs brute_force() const { return test::brute_force(mesh_a, mesh_b, pose); }
};

/// How large a scene is: coordinates, triangles, and the translation.
struct Scale {
  std::int32_t spread;
  std::int32_t size;
  std::int32_t reach;
};
constexpr Scale kSmall = {30, 25, 20};
constexpr Scale kNear = {300, 200, 250};
constexpr Scale kLargest = {16383, 9000, 15000};
constexpr Scale kTouching = {3, 2, 2};  ///< most pairs that meet touch, or share a plane

template <Layout layout>
Scene<layout> any_scene(Random& random, std::uint32_t most, const Scale& scale) {
  Scene<layout> scene{random_mesh(random, 1 + random.below(most), scale.spread, scale.size),
                      random_mesh(random, 1 + random.below(most), scale.spread, scale.size),
                      {},
                      {},
                      any_rigid_pose(random, scale.reach)};
  if (random.below(2) == 0) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      scene.mesh_a.origin[axis] = random.between(-20, 20);
      scene.mesh_b.origin[axis] = random.between(-20, 20);
    }
  }
  scene.a = bake::lay_out<std::uint16_t, layout>(any_tree(random, scene.mesh_a), scene.mesh_a);
  scene.b = bake::lay_out<std::uint16_t, layout>(any_tree(random, scene.mesh_b), scene.mesh_b);
  return scene;
}

template <class Traversal>
void check_against_brute_force(Random& random, const Scale& scale, int rounds) {
  std::size_t total = 0;
  for (int round = 0; round < rounds; ++round) {
    CAPTURE(round);
    const auto scene = any_scene<Traversal::Tree::kLayout>(random, 20, scale);
    REQUIRE(scene.pose.status() == Status::done);
    AnyQuery<Traversal> any(scene);
    Pairs pairs = run_to_end(any.query, kNoLimit, 10000);
    REQUIRE(any.query.counts().triangle_pairs == pairs.size());
    std::sort(pairs.begin(), pairs.end());
    REQUIRE(pairs == scene.brute_force());
    total += pairs.size();
  }
  CHECK(total > 20);
}

}  // namespace

TEMPLATE_TEST_CASE("under any rotation a query finds exactly the pairs that brute force finds", "",
                   Ranked<PostTree>, RankedStack<PostTree>, StacklessPost, Stackless,
                   Leaf<PostTree>, Leaf<PreTree>, VolumeStack<PostTree>, VolumeStack<PreTree>,
                   AlternatingStack<LevelledPostTree>, AlternatingStack<LevelledPreTree>) {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed);
  check_against_brute_force<TestType>(random, kSmall, 60);
  check_against_brute_force<TestType>(random, kNear, 40);
  check_against_brute_force<TestType>(random, kLargest, 40);
  check_against_brute_force<TestType>(random, kTouching, 40);
}
