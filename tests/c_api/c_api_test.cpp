// The C interface against the C++ one on random meshes and poses; the queries are made in C.
#include <catch2/catch.hpp>

#include <vector>

#include "bake/image_bytes.hpp"
#include "c_api/queries.h"
#include "flashbvh/image.hpp"
#include "flashbvh/query.hpp"
#include "heap_guard.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

/// A random mesh's image, opened in both languages.
struct Object {
  std::vector<std::uint32_t> image;
  LevelledPostMesh tree;
  flashbvh_mesh c_tree;

  explicit Object(Random& random) {
    auto mesh = random_mesh(random, 1 + random.below(24), 30, 25);
    for (std::int32_t& origin : mesh.origin) {
      origin = random.between(-10, 10);
    }
    image = image_of(
        bake::lay_out<std::uint16_t, Layout::post_indexed>(any_tree(random, mesh), mesh), true);
    REQUIRE(open_image(image.data(), bytes(), tree) == Status::done);
    REQUIRE(flashbvh_open(image.data(), bytes(), &c_tree) == FLASHBVH_STATUS_DONE);
    REQUIRE(flashbvh_mesh_triangles(&c_tree) == mesh.triangles.size());
    REQUIRE(flashbvh_mesh_cell(&c_tree) == tree.cell_bits);
  }

  std::size_t bytes() const { return image.size() * sizeof image[0]; }
};

/// The numbers of a pose, made in C++, taken to C.
flashbvh_pose c_pose(const Pose& pose) {
  std::int32_t rotation[9];
  std::int32_t cells[3];
  std::int16_t fraction[3];
  for (int i = 0; i < 3; ++i) {
    cells[i] = pose.translation(i);
    fraction[i] = static_cast<std::int16_t>(pose.fraction(i));
    for (int j = 0; j < 3; ++j) {
      rotation[3 * i + j] = pose.rotation(i, j);
    }
  }
  flashbvh_pose made;
  REQUIRE(flashbvh_pose_rigid(rotation, cells, fraction, &made) == FLASHBVH_STATUS_DONE);
  return made;
}

bool same(const Pose& pose, const flashbvh_pose& c) {
  std::int32_t rotation[9];
  std::int32_t cells[3];
  std::int16_t fraction[3];
  flashbvh_pose_values(&c, rotation, cells, fraction);
  bool same = flashbvh_pose_status(&c) == static_cast<flashbvh_status>(pose.status());
  for (int i = 0; i < 3; ++i) {
    same = same && cells[i] == pose.translation(i) && fraction[i] == pose.fraction(i);
    for (int j = 0; j < 3; ++j) {
      same = same && rotation[3 * i + j] == pose.rotation(i, j);
    }
  }
  return same;
}

Pose any_pose(Random& random) {
  const std::int32_t x = random.between(-20, 20);
  return random.below(3) == 0 ? Pose::translated(x, -x, 0) : any_rigid_pose(random, 20);
}

/// A query in C++, in one run.
answer whole(const Object& a, const Object& b, const Pose& pose,
             std::vector<flashbvh_pair>& pairs) {
  PairQuery query(a.tree, b.tree, pose);
  const Status status = query.run(UINT32_MAX, [&](const PairQuery::Pair& pair) {
    pairs.push_back({pair.a, pair.b});
    return true;
  });
  const Counts& counts = query.counts();
  const auto count = static_cast<std::uint32_t>(pairs.size());
  return {pairs.data(),
          count,
          count,
          {counts.visits, counts.overlaps, counts.leaf_pairs, counts.triangle_pairs},
          static_cast<flashbvh_status>(status)};
}

constexpr std::uint32_t kRuns[] = {1, 2, 7, UINT32_MAX};
constexpr std::uint32_t kCapacities[] = {1, 3, 8};

bool same(const flashbvh_triangle& c, const Triangle& transformed) {
  bool same = true;
  for (int i = 0; i < 3; ++i) {
    same = same && c.corner[i].x == transformed.corner[i].x &&
           c.corner[i].y == transformed.corner[i].y && c.corner[i].z == transformed.corner[i].z;
  }
  return same;
}

}  // namespace

TEST_CASE("C gets the pairs that C++ gets, in slices, saved and resumed, and in one call") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 20);
  std::vector<flashbvh_pair> pairs(1000);
  std::size_t total = 0;
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const Object a(random);
    const Object b(random);
    const Pose pose = any_pose(random);
    const flashbvh_pose at = c_pose(pose);
    std::vector<flashbvh_pair> expected_pairs;
    const answer expected = whole(a, b, pose, expected_pairs);
    total += expected.count;
    for (const std::uint32_t work : kRuns) {
      for (const std::uint32_t capacity : kCapacities) {
        CAPTURE(work, capacity);
        answer got{pairs.data(), 1000, 0, {}, FLASHBVH_STATUS_FULL};
        answer resumed = got;
        {
          const HeapForbidden guard;
          query_in_slices(&a.c_tree, &b.c_tree, &at, work, capacity, &got);
        }
        REQUIRE(same_answer(&got, &expected));
        query_saved_and_resumed(&a.c_tree, &b.c_tree, &at, work, capacity, &resumed);
        REQUIRE(same_answer(&resumed, &expected));
      }
    }
    REQUIRE(questions_agree(&a.c_tree, &b.c_tree, &at, &expected));
  }
  CHECK(total > 100);
}

TEST_CASE("poses made in C are those made in C++, in place too") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 21);
  for (int round = 0; round < 300; ++round) {
    CAPTURE(round);
    const Pose p = any_pose(random);
    const Pose q = any_pose(random);
    const flashbvh_pose c_p = c_pose(p);
    const flashbvh_pose c_q = c_pose(q);
    REQUIRE(same(p, c_p));
    flashbvh_pose made = c_p;
    flashbvh_pose_composed(&made, &c_q, &made);
    REQUIRE(same(Pose::composed(p, q), made));
    made = c_q;
    flashbvh_pose_composed(&c_p, &made, &made);
    REQUIRE(same(Pose::composed(p, q), made));
    made = c_p;
    flashbvh_pose_inverse(&made, &made);
    REQUIRE(same(p.inverse(), made));
    made = c_p;
    flashbvh_pose_relative(&made, &c_q, &made);
    REQUIRE(same(Pose::relative(p, q), made));
  }
}

TEST_CASE("the triangles of the last pair are transformed as in C++") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 22);
  std::uint32_t total = 0;
  for (int round = 0; round < 40; ++round) {
    const Object a(random);
    const Object b(random);
    const Pose pose = any_pose(random);
    const flashbvh_pose at = c_pose(pose);
    PairQuery query(a.tree, b.tree, pose);
    flashbvh_query c_query;
    REQUIRE(flashbvh_query_start(&c_query, &a.c_tree, &b.c_tree, &at) == FLASHBVH_STATUS_SUSPENDED);
    for (;;) {
      PairQuery::Pair found[1];
      flashbvh_pair c_found[1];
      std::uint32_t count = 0;
      const Step step = query.run(UINT32_MAX, found);
      REQUIRE(flashbvh_query_run(&c_query, UINT32_MAX, c_found, 1, &count) ==
              static_cast<flashbvh_status>(step.status));
      REQUIRE(count == step.count);
      if (step.status == Status::done) {
        break;
      }
      Triangle transformed_a{};
      Triangle transformed_b{};
      flashbvh_triangle c_a;
      flashbvh_triangle c_b;
      query.last_pair(transformed_a, transformed_b);
      flashbvh_query_last_pair(&c_query, &c_a, &c_b);
      REQUIRE((same(c_a, transformed_a) && same(c_b, transformed_b)));
      ++total;
    }
  }
  CHECK(total > 50);
}

TEST_CASE("a copy of a query in C goes on by itself") {
  Random random(test_seed() + 23);
  const Object a(random);
  const flashbvh_pose at = c_pose(Pose::translated(0, 0, 0));
  flashbvh_query query;
  flashbvh_pair found[300];
  std::uint32_t count = 0;
  std::uint32_t copied_count = 0;
  CHECK(flashbvh_query_start(&query, &a.c_tree, &a.c_tree, &at) == FLASHBVH_STATUS_SUSPENDED);
  CHECK(flashbvh_query_run(&query, 1, found, 300, &count) != FLASHBVH_STATUS_FULL);
  flashbvh_query copy = query;
  CHECK(flashbvh_query_run(&query, UINT32_MAX, found, 300, &count) == FLASHBVH_STATUS_DONE);
  CHECK(flashbvh_query_run(&copy, UINT32_MAX, found, 300, &copied_count) == FLASHBVH_STATUS_DONE);
  CHECK(copied_count == count);
  CHECK(flashbvh_query_counts(&copy).visits == flashbvh_query_counts(&query).visits);
}
