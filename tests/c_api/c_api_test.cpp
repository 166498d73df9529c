// The C interface against the C++ one on random meshes and poses; the queries are made in C.
#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

#include "bake/image_bytes.hpp"
#include "c_api/queries.h"
#include "flashbvh/bound.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/pose_float.hpp"
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

bool same(const flashbvh_contact& c, const Contact& contact) {
  bool same = static_cast<int>(c.kind) == static_cast<int>(contact.kind);
  for (int i = 0; i < 2; ++i) {
    const FinePoint& end = contact.ends[i];
    same = same && c.ends[i].x == end.x && c.ends[i].y == end.y && c.ends[i].z == end.z;
  }
  const auto same_normal = [](const flashbvh_normal& n, const Normal& m) {
    return n.x == m.x && n.y == m.y && n.z == m.z;
  };
  return same && same_normal(c.normal_a, contact.normal_a) &&
         same_normal(c.normal_b, contact.normal_b);
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

TEST_CASE("poses made of floats in C are those made in C++") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 24);
  for (int round = 0; round < 300; ++round) {
    const Rotation rotation = rotation_of(any_quaternion(random));
    float rows[3][3];
    for (int i = 0; i < 9; ++i) {
      rows[i / 3][i % 3] = static_cast<float>(rotation.entry[i / 3][i % 3]) / kRotationOne;
    }
    const float translation[3] = {static_cast<float>(random.between(-9999, 9999)) / 7, -0.25f, 3};
    const float scale = static_cast<float>(random.between(1, 1000)) / 3;
    flashbvh_pose made;
    CHECK(flashbvh_pose_of_matrix(rows[0], translation, scale, &made) == FLASHBVH_STATUS_DONE);
    REQUIRE(same(pose_of(rows, translation, scale), made));
    const float q[4] = {0.5f, -0.5f, 0.5f, static_cast<float>(round % 2 == 0 ? 0.5 : 0.6)};
    flashbvh_pose_of_quaternion(q, translation, scale, &made);
    REQUIRE(flashbvh_pose_status(&made) ==
            (round % 2 == 0 ? FLASHBVH_STATUS_DONE : FLASHBVH_STATUS_NOT_A_ROTATION));
    const Pose wanted = pose_of(UnitQuaternion{q[0], q[1], q[2], q[3]}, translation, scale);
    REQUIRE((round % 2 != 0 || same(wanted, made)));
  }
}

TEST_CASE("bounds in C are those of C++") {
  Random random(test_seed() + 25);
  const RunCosts costs[] = {kCortexM0,  kCortexM3,  kCortexM4F, kCortexM7,
                            kCortexM33, kCortexM55, kRV32IMAC};
  const flashbvh_run_costs* const c_costs[] = {
      &flashbvh_cortex_m0,  &flashbvh_cortex_m3,  &flashbvh_cortex_m4f, &flashbvh_cortex_m7,
      &flashbvh_cortex_m33, &flashbvh_cortex_m55, &flashbvh_rv32imac};
  for (int round = 0; round < 50; ++round) {
    const Object object_a(random);
    const Object object_b(random);
    ImageHeader header;
    REQUIRE(read_image_header(object_a.image.data(), object_a.bytes(), header) == Status::done);
    const TreeSize a = tree_size_of(header);
    REQUIRE(read_image_header(object_b.image.data(), object_b.bytes(), header) == Status::done);
    const TreeSize b = tree_size_of(header);
    flashbvh_tree_size c_a;
    flashbvh_tree_size c_b;
    REQUIRE(flashbvh_image_tree_size(object_a.image.data(), object_a.bytes(), &c_a) ==
            FLASHBVH_STATUS_DONE);
    REQUIRE(flashbvh_image_tree_size(object_b.image.data(), object_b.bytes(), &c_b) ==
            FLASHBVH_STATUS_DONE);
    REQUIRE(flashbvh_image_tree_size(object_a.image.data(), 3, &c_a) ==
            FLASHBVH_STATUS_IMAGE_TRUNCATED);
    for (std::size_t core = 0; core < sizeof costs / sizeof costs[0]; ++core) {
      const std::uint64_t instructions = random.below(1000000);
      const std::uint32_t work = random.below(10000);
      REQUIRE(flashbvh_work_within(instructions, c_costs[core], &c_a, &c_b) ==
              work_within(instructions, costs[core], a, b));
      REQUIRE(flashbvh_most_instructions(c_costs[core], &c_a, &c_b, work) ==
              most_instructions(costs[core], a, b, work));
    }
    REQUIRE(flashbvh_most_work(&c_a, &c_b) == most_work(a, b));
    REQUIRE(flashbvh_largest_step(&c_a, &c_b) == largest_step(a, b));
  }
}

TEST_CASE("what C says of a mesh is what C++ has") {
  Random random(test_seed() + 26);
  for (int round = 0; round < 30; ++round) {
    const Object object(random);
    std::int32_t origin[3];
    flashbvh_mesh_origin(&object.c_tree, origin);
    CHECK(std::equal(origin, origin + 3, object.tree.origin));
    CHECK(flashbvh_mesh_unit(&object.c_tree) == static_cast<flashbvh_unit>(object.tree.unit));
    CHECK(flashbvh_mesh_is_closed(&object.c_tree) == object.tree.is_closed);
    CHECK(flashbvh_mesh_cells_per_unit(&object.c_tree) == cells_per_unit(object.tree.cell_bits));
  }
}

TEST_CASE("a run in C says what work is left, and hands pairs to a visitor") {
  Random random(test_seed() + 27);
  const Object a(random);
  const flashbvh_pose at = c_pose(Pose::translated(0, 0, 0));
  const Pose pose = Pose::translated(0, 0, 0);
  for (const std::uint32_t granted : kRuns) {
    PairQuery query(a.tree, a.tree, pose);
    flashbvh_query spending;
    flashbvh_query visited;
    CHECK(flashbvh_query_start(&spending, &a.c_tree, &a.c_tree, &at) == FLASHBVH_STATUS_SUSPENDED);
    CHECK(flashbvh_query_start(&visited, &a.c_tree, &a.c_tree, &at) == FLASHBVH_STATUS_SUSPENDED);
    for (Status status = Status::suspended; status != Status::done;) {
      PairQuery::Pair found[3];
      flashbvh_pair c_found[3];
      std::uint32_t count = 0;
      std::uint32_t left = granted;
      std::uint32_t visit_left = granted;
      std::uint32_t room = 3;
      const Step step = query.run(granted, found);
      status = step.status;
      REQUIRE(flashbvh_query_spend(&spending, &left, c_found, 3, &count) ==
              static_cast<flashbvh_status>(status));
      REQUIRE(count == step.count);
      REQUIRE(granted - left == step.work);
      const auto take = [](flashbvh_pair, void* context) {
        return --*static_cast<std::uint32_t*>(context) != 0;
      };
      REQUIRE(flashbvh_query_visit(&visited, &visit_left, take, &room) ==
              static_cast<flashbvh_status>(status));
      REQUIRE(3 - room == step.count);
    }
  }
}

TEST_CASE(
    "the triangles of the last pair are transformed as in C++, and their contact is the same") {
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
      REQUIRE(flashbvh_transform_pair(&a.c_tree, &b.c_tree, &at, c_found[0], &c_b, &c_a));
      REQUIRE((same(c_b, transformed_a) && same(c_a, transformed_b)));
      flashbvh_contact c_contact;
      flashbvh_contact again;
      flashbvh_query_last_contact(&c_query, &c_contact);
      flashbvh_contact_of(&c_b, &c_a, &again);
      const Contact contact = contact_of(transformed_a, transformed_b);
      REQUIRE((same(c_contact, contact) && same(again, contact)));
      float at_float[3];
      std::int64_t millionths[3];
      flashbvh_in_unit(&c_contact.ends[1], &a.c_tree, at_float);
      flashbvh_in_millionths(&c_contact.ends[1], &a.c_tree, millionths);
      const UnitPoint wanted = in_unit(contact.ends[1], a.tree.cell_bits);
      REQUIRE((at_float[0] == wanted.x && at_float[1] == wanted.y && at_float[2] == wanted.z));
      REQUIRE(millionths[2] == millionths_of(contact.ends[1].z, a.tree.cell_bits));
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
