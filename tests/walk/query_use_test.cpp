// Uses of a query in addition to running it: reading counts inside a sink, keeping the cursor of a
// finished query, and refusing temporary arguments before the first run.
#include <type_traits>

#include "bake/baked_tree.hpp"
#include "flashbvh/query.hpp"
#include "reference/leaf.hpp"
#include "reference/stackless.hpp"
#include "support/queries.hpp"
#include "support/record.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

namespace {

template <class A, class B, class P>
constexpr bool kTakes = std::is_constructible<PairQuery, A, B, P>::value;
static_assert(kTakes<const Mesh&, const Mesh&, const Pose&>);
static_assert(kTakes<const MeshWithLevels&, const Mesh&, Pose&>);
static_assert(!kTakes<Mesh, const Mesh&, const Pose&>, "a mesh gone before the first run");
static_assert(!kTakes<const Mesh&, Mesh, const Pose&>);
static_assert(!kTakes<const Mesh&, const Mesh&, Pose>);
static_assert(!kTakes<Mesh, Mesh, Pose>);
static_assert(!kTakes<MeshWithLevels, const Mesh&, const Pose&>);

struct Scene {
  Baked<Layout::post_indexed> a, b;
};

Scene overlapping_scene(Random& random) {
  const auto mesh_a = random_mesh(random, 25, 30, 25);
  const auto mesh_b = random_mesh(random, 25, 30, 25);
  return {bake::lay_out<std::uint16_t, Layout::post_indexed>(any_tree(random, mesh_a), mesh_a),
          bake::lay_out<std::uint16_t, Layout::post_indexed>(any_tree(random, mesh_b), mesh_b)};
}

}  // namespace

TEST_CASE("inside a sink stats() says what was done so far, not what was granted") {
  Random random = test_random();
  const Scene scene = overlapping_scene(random);
  const auto a = scene.a.view();
  const auto b = scene.b.view();
  const Pose pose = Pose::translated(1, 2, 3);
  std::vector<QueryStats> inside;
  PairQuery whole(a, b, pose);
  REQUIRE(whole
              .run(1000000,
                   [&](const PairQuery::Pair&) {
                     inside.push_back(whole.stats());
                     return true;
                   })
              .status == Status::done);
  REQUIRE(inside.size() > 20);
  // Equal to the counts of a run that ends with a full array.
  PairQuery cut(a, b, pose);
  PairQuery::Pair found[1];
  for (const QueryStats& counts : inside) {
    REQUIRE(cut.run(1000000, found).status == Status::full);
    CHECK(counts.visits == cut.stats().visits);
    CHECK(counts.overlaps == cut.stats().overlaps);
    CHECK(counts.leaf_pairs == cut.stats().leaf_pairs);
    CHECK(counts.triangle_pairs == cut.stats().triangle_pairs);
  }
}

TEMPLATE_TEST_CASE("the position of a query that is done is taken, and stays done", "",
                   Ranked<Mesh>, StacklessPost, Leaf<Mesh>) {
  Random random = test_random();
  const Scene scene = overlapping_scene(random);
  const auto a = scene.a.view();
  const auto b = scene.b.view();
  const Pose pose = Pose::translated(1, 2, 3);
  Query<TestType> query(a, b, pose);
  REQUIRE(!run_to_end(query, kNoLimit, 100).empty());
  Query<TestType> other(a, b, pose);
  CHECK(other.resume(query.cursor()) == Status::done);
  CHECK(run_to_end(other, kNoLimit, 100).empty());
  CHECK(other.stats().visits == 0);
}
