// Each C function against its C++ counterpart, on random meshes and poses.
#include <catch2/catch.hpp>

#include "bake/image_bytes.hpp"
#include "c_api/scene.hpp"
#include "flashbvh/image.hpp"
#include "heap_guard.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"
#include "support/torus.hpp"

namespace flashbvh::test {
namespace {

bake::LatticeMesh any_mesh(Random& random) {
  if (random.below(3) == 0) {
    return torus(3 + random.below(5), 3, 20, 8);
  }
  auto mesh = random_mesh(random, 1 + random.below(24), 30, 25);
  for (std::int32_t& origin : mesh.origin) {
    origin = random.between(-10, 10);
  }
  return mesh;
}

Pose any_pose(Random& random) {
  const std::int32_t x = random.between(-20, 20);
  const std::uint32_t kind = random.below(9);
  return kind == 0  ? Pose::translated(x, kMaxTranslation + 1, 0)
         : kind < 3 ? Pose::translated(x, -x, 0)
                    : any_rigid_pose(random, 40);
}

std::uint32_t any_distance(Random& random) {
  return random.below(8) == 0 ? kMaxDistance + random.below(2) : random.below(60) * 100;
}

/// All statuses except those of C++ alone and of robots.
std::uint64_t all_statuses() {
  std::uint64_t all = 0;
  for (int i = 0; i < 64; ++i) {
    const auto status = static_cast<flashbvh_status>(i);
    const bool is_named = std::strcmp(flashbvh_status_name(status), "unknown") != 0;
    const bool is_other =
        status == FLASHBVH_STATUS_STACK_TOO_SMALL || status == FLASHBVH_STATUS_IMAGE_TOO_LARGE ||
        status == FLASHBVH_STATUS_MESH_CHANGED || status == FLASHBVH_STATUS_SELF_TEST_FAILED ||
        (i >= FLASHBVH_STATUS_NOT_A_COORDINATE && i <= FLASHBVH_STATUS_LINK_INVALID);
    all |= std::uint64_t{is_named && !is_other} << i;
  }
  return all;
}

}  // namespace

std::uint64_t seen_statuses;
std::uint32_t seen_outcomes;

Object::Object(Random& random, double cell) {
  const auto source = any_mesh(random);
  auto baked = bake::lay_out<std::uint16_t, Layout::post_indexed>(any_tree(random, source), source);
  baked.cell = cell;
  image = bake::image_of(baked);
  REQUIRE(open_image(image.data(), size(), mesh) == Status::done);
  REQUIRE(flashbvh_open(image.data(), size(), &c) == FLASHBVH_STATUS_DONE);
}

Scene::Scene(Random& from)
    : random(from),
      a(from, 1),
      b(from, from.below(9) == 0 ? 0.5 : 1),
      damaged(a.image.size() + 1),
      pose(any_pose(from)),
      c_pose(c_pose_of(pose)),
      distance(any_distance(from)) {
  if (from.below(9) == 0) {
    b.mesh = {};
    b.c = {};
  }
}

Point Scene::any_point() {
  const std::int32_t x = random.between(-40, 40);
  const std::int32_t y = random.between(-40, 40);
  return {x, y, random.between(-40, 40)};
}

bool same(const flashbvh_clearance& c, const Clearance<std::uint16_t>& known) {
  return same(c.status, known.status) && c.in_range == known.in_range && c.lower == known.lower &&
         c.upper == known.upper && same(c.triangles, known.triangles) &&
         c.witness.a == known.witness.a && c.witness.b == known.witness.b &&
         same(c.point_a, known.point_a) && same(c.point_b, known.point_b) &&
         same(c.direction, known.direction);
}

}  // namespace flashbvh::test

using namespace flashbvh;
using namespace flashbvh::test;

TEST_CASE("each function of C answers as its counterpart in C++") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 20);
  std::uint32_t pairs = 0;
  for (int round = 0; round < 150; ++round) {
    CAPTURE(round);
    Scene scene(random);
    pairs += count_pairs(scene.a.mesh, scene.b.mesh, scene.pose).count;
    for (const auto& rows : {pair_rows(), distance_rows(), body_rows()}) {
      for (const Row& row : rows) {
        bool agrees = false;
        {
          const HeapForbidden guard;
          agrees = row.agree(scene);
        }
        CAPTURE(row.name);
        REQUIRE(agrees);
      }
    }
  }
  CHECK(pairs > 100);
  CHECK(seen_statuses == all_statuses());
  CHECK(seen_outcomes == 7);
}
