// Every traversal against brute force, translated and rotated, on trees that fit every board.
#include <initializer_list>

#include "flashbvh/contact.hpp"
#include "flashbvh/image.hpp"
#include "support/points.hpp"
#include "support/rounds.hpp"
#include "support/small_scene.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

const int kRounds = rounds(300, 2000);

}  // namespace

TEST_CASE("small trees: a query finds exactly the pairs that brute force finds") {
  for_each_order<uint16_t>([](auto named) {
    using Traversal = typename decltype(named)::Traversal;
    CAPTURE(named.name);
    uint32_t total = 0;
    for_rounds(kRounds, [&](Random& random, int) {
      const SmallScene<Traversal::Tree::kLayout> scene(random);
      SmallQuery<Traversal> any(scene);
      const bool exact = all_pairs(any.query) == brute_force(scene);
      REQUIRE(exact);
      total += any.query.stats().triangle_pairs;
    });
    CHECK(total > static_cast<uint32_t>(kRounds));
  });
}

TEST_CASE("small trees: a reported pair lies where the pose's definition puts it") {
  const Pose identity = Pose::translated(0, 0, 0);
  for_rounds(kRounds, 2, [&](Random& random, int) {
    const SmallScene<Layout::post_indexed> scene(random);
    const Mesh& a = scene.a.view();
    const Mesh& b = scene.b.view();
    PairQuery query(a, b, scene.pose);
    uint32_t wrong = 0;
    const Status status =
        query
            .run(kNoLimit,
                 [&](const Pair& pair) {
                   Triangle last[2];
                   Triangle again[2];
                   query.last_pair(last[0], last[1]);
                   const bool found = transform_pair(a, b, scene.pose, pair, again[0], again[1]);
                   const Triangle of_a = transformed(scene.mesh_a, pair.a, identity);
                   const Triangle of_b = transformed(scene.mesh_b, pair.b, scene.pose);
                   const bool right = found && same(last[0], of_a) && same(last[1], of_b) &&
                                      same(again[0], of_a) && same(again[1], of_b);
                   wrong += right ? 0u : 1u;
                   return true;
                 })
            .status;
    REQUIRE(status == Status::done);
    REQUIRE(wrong == 0);
  });
}

TEST_CASE("small trees: every triangle of B lies where the pose's definition puts it") {
  int compared = 0;
  for_rounds(kRounds, 4, [&](Random& random, int) {
    const SmallScene<Layout::post_indexed> scene(random);
    const Mesh& a = scene.a.view();
    const Mesh& b = scene.b.view();
    bool is_near = true;  // a far B is placed where it intersects nothing
    for (int axis = 0; axis < 3; ++axis) {
      const int32_t middle = transformed_coordinate(b.origin, {0, 0, 0}, scene.pose, axis);
      is_near =
          is_near && middle - a.origin[axis] < kMaxOffset && middle - a.origin[axis] > -kMaxOffset;
    }
    for (uint16_t triangle = 0; is_near && triangle < b.triangle_count; ++triangle) {
      Triangle of_a;
      Triangle of_b;
      REQUIRE(transform_pair(a, b, scene.pose, {0, triangle}, of_a, of_b));
      const bool right = same(of_b, transformed(scene.mesh_b, triangle, scene.pose));
      REQUIRE(right);
      ++compared;
    }
  });
  CHECK(compared > kRounds);
}

TEST_CASE("small trees: each kind of misuse has its own status") {
  Random random = test_random(3);
  const SmallScene<Layout::post_indexed> scene(random);
  const Mesh& a = scene.a.view();
  const Mesh& b = scene.b.view();
  const Pose here = Pose::translated(0, 0, 0);
  Pair found[1];

  PairQuery query(a, b, here);
  CHECK(query.run(10, found, 0).status == Status::full);  // no memory for a pair
  CHECK(query.run(0, found).status == Status::suspended);
  CHECK(query.stats().visits == 0);
  (void)query.run(1, found);
  CHECK(query.stats().visits == 1);
  while (query.status() == Status::suspended) {
    (void)query.run(kNoLimit, found);
  }
  const QueryStats counts = query.stats();
  const RunResult step = query.run(kNoLimit, found);  // again after the end
  CHECK(step.status == Status::done);
  CHECK(step.count == 0);
  CHECK(same(query.stats(), counts));

  const uint32_t needed = stack_entries(a.stack_need, b.stack_need);
  PairCursor<uint16_t> entries[2 * digest::kMostTriangles];
  using VolumeQuery = Query<VolumeStackPost>;
  CHECK(VolumeQuery(a, b, here, {entries, needed}).status() == Status::suspended);
  CHECK(VolumeQuery(a, b, here, {entries, needed - 1}).status() == Status::stack_too_small);
  CHECK(VolumeQuery(a, b, here, {nullptr, 0}).status() == Status::stack_too_small);
}

TEST_CASE("small trees: meshes and poses that no query takes each have their own status") {
  Random random = test_random(3);
  const SmallScene<Layout::post_indexed> scene(random);
  const Mesh& a = scene.a.view();
  const auto check_refused = [&a](const Mesh& b, const Pose& pose, Status status) {
    Pair found[1];
    PairQuery query(a, b, pose);
    CHECK(query.status() == status);
    CHECK(query.run(kNoLimit, found).status == status);
    CHECK(query.stats().visits == 0);
  };
  Mesh b = scene.b.view();
  for (const int32_t t : {kMaxTranslation + 1, -kMaxTranslation - 1, INT32_MAX, INT32_MIN}) {
    for (const Pose& pose :
         {Pose::translated(t, 0, 0), Pose::translated(0, t, 0), Pose::translated(0, 0, t)}) {
      check_refused(b, pose, Status::translation_out_of_range);
    }
  }
  for (const int32_t t : {kMaxTranslation, -kMaxTranslation}) {
    Pair found[1];
    const Pose farthest = Pose::translated(t, t, t);
    CHECK(PairQuery(a, b, farthest).run(kNoLimit, found).status == Status::done);
  }
  check_refused(b, Pose::rigid({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}),
                Status::not_a_rotation);
  b.cell_bits ^= 1;  // different cells
  check_refused(b, Pose::translated(0, 0, 0), Status::cell_mismatch);
}
