// Positions: saved, and carried over to another query object. What is none is refused:
// resume_board_test.cpp; all that can be one lead to an end: golden/resume_test.cpp.
#include <catch2/catch.hpp>

#include <cstring>

#include "support/queries.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

template <Layout layout>
struct Scene {
  Baked<layout> a, b;
  Pose pose;
};

template <Layout layout>
Scene<layout> any_scene(Random& random) {
  const auto bake_any = [&random] {
    const bake::LatticeMesh mesh = random_mesh(random, 1 + random.below(16), 30, 25);
    return bake::lay_out<std::uint16_t, layout>(any_tree(random, mesh), mesh);
  };
  Scene<layout> scene{bake_any(), bake_any(), Pose::translated(0, 0, 0)};
  scene.pose = random.below(2) == 0
                   ? any_rigid_pose(random, 20)
                   : Pose::translated(random.between(-9, 9), random.between(-9, 9), 0);
  return scene;
}

}  // namespace

TEST_CASE("a query saved after any run and resumed in a new object goes on as if it had not") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  for_each_stackless_order<std::uint16_t>([seed](auto named) {
    using Order = typename decltype(named)::Order;
    CAPTURE(named.name, static_cast<int>(Order::Tree::kLayout));
    Random random(seed);
    for (int round = 0; round < rounds(15, 60); ++round) {
      CAPTURE(round);
      const auto scene = any_scene<Order::Tree::kLayout>(random);
      AnyQuery<Order> whole(scene);
      const Pairs expected = run_to_end(whole.query, kNoLimit, 10000);
      Pairs pairs;
      QueryPosition<std::uint16_t> position;
      std::uint32_t visits = 0;
      for (Status status = Status::suspended; status != Status::done;) {
        unsigned char stored[sizeof position];
        std::memcpy(stored, &position, sizeof position);  // as bytes, in flash or elsewhere
        QueryPosition<std::uint16_t> loaded;
        std::memcpy(&loaded, stored, sizeof loaded);
        AnyQuery<Order> any(scene);
        status = any.query.resume(loaded);
        REQUIRE((status == Status::suspended || status == Status::done));
        typename Query<Order>::Pair found[1];
        const Step step = any.query.run(1 + random.below(3), found);
        status = step.status;
        if (step.count != 0) {
          pairs.emplace_back(found[0].a, found[0].b);
        }
        visits += any.query.counts().visits;
        position = any.query.position();
      }
      REQUIRE(pairs == expected);
      REQUIRE(visits == whole.query.counts().visits);
    }
  });
}

TEST_CASE("two queries on the same trees may take turns, one interrupting the other") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 2);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    auto scene = any_scene<Layout::post_indexed>(random);
    const Pose other = any_rigid_pose(random, 20);
    AnyQuery<Ranked<PostMesh>> first(scene);
    const Pairs expected_first = run_to_end(first.query, kNoLimit, 10000);
    PairQuery second(first.a, first.b, other);
    const Pairs expected_second = run_to_end(second, kNoLimit, 10000);

    PairQuery outer(first.a, first.b, scene.pose);
    Pairs pairs_outer;
    Pairs pairs_inner;
    // The inner one runs in the middle of the outer one's report, as an interrupt would.
    PairQuery inner(first.a, first.b, other);
    const auto interrupt = [&] {
      (void)inner.run(2, [&](const PairQuery::Pair& pair) {
        pairs_inner.emplace_back(pair.a, pair.b);
        return true;
      });
    };
    while (outer.status() == Status::suspended) {
      (void)outer.run(3, [&](const PairQuery::Pair& pair) {
        pairs_outer.emplace_back(pair.a, pair.b);
        interrupt();
        return true;
      });
      interrupt();
    }
    while (inner.status() == Status::suspended) {
      interrupt();
    }
    REQUIRE(pairs_outer == expected_first);
    REQUIRE(pairs_inner == expected_second);
  }
}
