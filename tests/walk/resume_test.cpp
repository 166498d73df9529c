// Alternating queries on the same trees. For saved cursors resumed in another query object:
// resume_board_test.cpp; for every possible cursor: golden/resume_test.cpp.
#include "support/any_mesh.hpp"
#include "support/test.hpp"

TEST_CASE("two queries on the same trees may take turns, one interrupting the other") {
  for_rounds(40, 2, [&](Random& random, int) {
    const Scene scene = any_scene(random);
    const Mesh& a = scene.a;
    const Mesh& b = scene.b;
    const Pose other = any_rigid_pose(random, 20);
    PairQuery first(a, b, scene.pose);
    const Pairs expected_first = run_to_end(first);
    PairQuery second(a, b, other);
    const Pairs expected_second = run_to_end(second);

    PairQuery outer(a, b, scene.pose);
    Pairs pairs_outer;
    Pairs pairs_inner;
    // The inner query runs during the outer one's report, like an interrupt.
    PairQuery inner(a, b, other);
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
  });
}
