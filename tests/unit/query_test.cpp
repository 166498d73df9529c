// Queries: exact pairs, cut into runs in every way, and every status.
#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "bake/baked_tree.hpp"
#include "flashbvh/query.hpp"
#include "support/queries.hpp"
#include "support/shapes.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

using Pair = TrianglePair<std::uint16_t>;

struct Scene {
  bake::LatticeMesh mesh_a, mesh_b;
  Baked<Layout::post_indexed> a, b;
  Pose pose;
};

Scene any_scene(Random& random, std::uint32_t most) {
  Scene scene{random_mesh(random, 1 + random.below(most), 30, 25),
              random_mesh(random, 1 + random.below(most), 30, 25),
              {},
              {},
              Pose::translated(0, 0, 0)};
  std::int32_t t[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    scene.mesh_a.origin[axis] = random.between(-5000, 5000);
    scene.mesh_b.origin[axis] = random.between(-5000, 5000);
    t[axis] = scene.mesh_a.origin[axis] - scene.mesh_b.origin[axis] + random.between(-20, 20);
  }
  scene.pose = Pose::translated(t[0], t[1], t[2]);
  scene.a = bake::lay_out<std::uint16_t, Layout::post_indexed>(any_tree(random, scene.mesh_a),
                                                               scene.mesh_a);
  scene.b = bake::lay_out<std::uint16_t, Layout::post_indexed>(any_tree(random, scene.mesh_b),
                                                               scene.mesh_b);
  return scene;
}

Triangle placed(const bake::LatticeMesh& mesh, std::uint32_t triangle, const Pose& pose) {
  Triangle placed{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex& v = mesh.vertices[mesh.triangles[triangle][i]];
    placed.corner[i] = {v.x + mesh.origin[0] + pose.translation(0),
                        v.y + mesh.origin[1] + pose.translation(1),
                        v.z + mesh.origin[2] + pose.translation(2)};
  }
  return placed;
}

/// All pairs of triangles of the two meshes, in order.
Pairs brute_force(const Scene& scene) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < scene.mesh_a.triangles.size(); ++i) {
    for (std::uint32_t j = 0; j < scene.mesh_b.triangles.size(); ++j) {
      if (triangles_intersect(placed(scene.mesh_a, i, Pose::translated(0, 0, 0)),
                              placed(scene.mesh_b, j, scene.pose))) {
        pairs.emplace_back(i, j);
      }
    }
  }
  return pairs;
}

constexpr std::uint32_t kRuns[] = {1, 2, 3, 7, 50, kNoLimit};
constexpr std::uint32_t kCapacities[] = {1, 2, 5};

bool same(const Counts& a, const Counts& b) {
  return a.visits == b.visits && a.overlaps == b.overlaps && a.leaf_pairs == b.leaf_pairs &&
         a.triangle_pairs == b.triangle_pairs;
}

}  // namespace

TEMPLATE_TEST_CASE("a query finds exactly the pairs that brute force finds", "", Ranked<PostMesh>,
                   RankedStack<PostMesh>, StacklessPost, Leaf<PostMesh>, VolumeStack<PostMesh>,
                   AlternatingStack<LevelledPostMesh>) {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed);
  std::size_t total = 0;
  for (int round = 0; round < 100; ++round) {
    CAPTURE(round);
    const Scene scene = any_scene(random, 20);
    AnyQuery<TestType> any(scene);
    Pairs pairs = run_to_end(any.query, kNoLimit, 10000);
    REQUIRE(any.query.counts().triangle_pairs == pairs.size());
    REQUIRE(any.query.status() == Status::done);
    std::sort(pairs.begin(), pairs.end());
    REQUIRE(pairs == brute_force(scene));
    total += pairs.size();
  }
  CHECK(total > 100);
}

TEMPLATE_TEST_CASE("however a query is cut into runs, it gives the same pairs in the same order",
                   "", Ranked<PostMesh>, StacklessPost, Leaf<PostMesh>, VolumeStack<PostMesh>) {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 1);
  for (int round = 0; round < 25; ++round) {
    CAPTURE(round);
    const Scene scene = any_scene(random, 14);
    AnyQuery<TestType> whole(scene);
    const Pairs expected = run_to_end(whole.query, kNoLimit, 10000);
    for (const std::uint32_t visits : kRuns) {
      for (const std::uint32_t capacity : kCapacities) {
        CAPTURE(visits, capacity);
        AnyQuery<TestType> cut(scene);
        REQUIRE(run_to_end(cut.query, visits, capacity) == expected);
        REQUIRE(same(cut.query.counts(), whole.query.counts()));
      }
    }
  }
}

TEST_CASE("a run makes no more visits than granted, and a suspended query is not done") {
  Random random(test_seed() + 2);
  const Scene scene = any_scene(random, 20);
  const auto a = scene.a.view();
  const auto b = scene.b.view();
  PairQuery query(a, b, scene.pose);
  Pair found[1000];
  CHECK(query.run(0, found).status == Status::suspended);
  CHECK(query.counts().visits == 0);
  CHECK(query.run(1, found).status == Status::suspended);
  CHECK(query.counts().visits == 1);
}

TEST_CASE("running a finished query again changes nothing") {
  Random random(test_seed() + 3);
  const Scene scene = any_scene(random, 5);
  const auto a = scene.a.view();
  const auto b = scene.b.view();
  PairQuery query(a, b, scene.pose);
  (void)run_to_end(query, kNoLimit, 1000);
  const Counts counts = query.counts();
  Pair found[4];
  const Step step = query.run(kNoLimit, found);
  CHECK(step.status == Status::done);
  CHECK(step.count == 0);
  CHECK(same(query.counts(), counts));
}

TEST_CASE("each way to ask wrongly has its own status") {
  Random random(test_seed() + 4);
  const Scene scene = any_scene(random, 5);
  const auto a = scene.a.view();
  auto b = scene.b.view();
  Pair found[1];
  SECTION("no room for a pair") {
    PairQuery query(a, b, scene.pose);
    CHECK(query.run(10, found, 0).status == Status::full);
    CHECK(query.counts().visits == 0);
  }
  SECTION("different cells") {
    b.cell_bits ^= 1;
    PairQuery query(a, b, scene.pose);
    CHECK(query.status() == Status::cell_mismatch);
    CHECK(query.run(kNoLimit, found).status == Status::cell_mismatch);
    CHECK(query.counts().visits == 0);
  }
  SECTION("a translation out of range") {
    const std::int32_t wrong[] = {kMaxTranslation + 1, -kMaxTranslation - 1, INT32_MAX, INT32_MIN};
    for (const std::int32_t t : wrong) {
      for (const Pose& pose :
           {Pose::translated(t, 0, 0), Pose::translated(0, t, 0), Pose::translated(0, 0, t)}) {
        CHECK(pose.status() == Status::translation_out_of_range);
        CHECK(PairQuery(a, b, pose).status() == Status::translation_out_of_range);
        CHECK(PairQuery(a, b, pose).run(kNoLimit, found).status ==
              Status::translation_out_of_range);
      }
    }
    for (const std::int32_t t : {kMaxTranslation, -kMaxTranslation}) {
      const Pose pose = Pose::translated(t, t, t);
      CHECK(PairQuery(a, b, pose).run(kNoLimit, found).status == Status::done);
    }
  }
  SECTION("a stack that is too short") {
    const std::uint32_t needed = stack_entries(a.stack_need, b.stack_need);
    std::vector<PairCursor<std::uint16_t>> entries(needed);
    using VolumeQuery = Query<VolumeStack<PostMesh>>;
    CHECK(VolumeQuery(a, b, scene.pose, {entries.data(), needed}).status() == Status::suspended);
    CHECK(VolumeQuery(a, b, scene.pose, {entries.data(), needed - 1}).status() ==
          Status::stack_too_small);
    CHECK(VolumeQuery(a, b, scene.pose, {nullptr, 0}).status() == Status::stack_too_small);
  }
}
