// Uses of a query in addition to running it: reading counts inside a sink, keeping the cursor of a
// finished query, and refusing temporary arguments before the first run.
#include <type_traits>

#include "support/any_mesh.hpp"
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

Scene overlapping_scene(Random& random) {
  const auto mesh = [&] { return any_mesh(random, random_mesh(random, 25, 30, 25)); };
  return {mesh(), mesh(), Pose::translated(1, 2, 3)};
}

}  // namespace

TEST_CASE("inside a sink stats() says what was done so far, not what was granted") {
  Random random = test_random();
  const Scene scene = overlapping_scene(random);
  std::vector<QueryStats> inside;
  PairQuery whole(scene.a, scene.b, scene.pose);
  REQUIRE(whole
              .run(1000000,
                   [&](const PairQuery::Pair&) {
                     inside.push_back(whole.stats());
                     return true;
                   })
              .status == Status::done);
  REQUIRE(inside.size() > 20);
  // Equal to the counts of a run that ends with a full array.
  PairQuery cut(scene.a, scene.b, scene.pose);
  PairQuery::Pair found[1];
  for (const QueryStats& counts : inside) {
    REQUIRE(cut.run(1000000, found).status == Status::full);
    CHECK(same(counts, cut.stats()));
  }
}

TEMPLATE_TEST_CASE("the position of a query that is done is taken, and stays done", "",
                   Ranked<Mesh>, StacklessPost, Leaf<Mesh>) {
  Random random = test_random();
  const Scene scene = overlapping_scene(random);
  using Tree = typename TestType::Tree;
  const Tree a = scene.a.view<Tree>();
  const Tree b = scene.b.view<Tree>();
  Query<TestType> query(a, b, scene.pose);
  REQUIRE(!run_to_end(query).empty());
  Query<TestType> other(a, b, scene.pose);
  CHECK(other.resume(query.cursor()) == Status::done);
  CHECK(run_to_end(other).empty());
  CHECK(other.stats().visits == 0);
}
