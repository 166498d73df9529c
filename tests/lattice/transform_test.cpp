// What a query makes of a pose: transformed vertices, and the tests of boxes that must not lose
// them.
#include <catch2/catch.hpp>

#include <cstdlib>

#include "support/queries.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"
#include "support/transformed_mesh.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

TEST_CASE("no box test rejects boxes with a transformed vertex of one in the other") {
  Random random = test_random(2);
  for (int round = 0; round < rounds(600, 3000); ++round) {
    CAPTURE(round);
    const std::int32_t spread = round % 3 == 0 ? 16383 : round % 3 == 1 ? 400 : 12;
    bake::LatticeMesh mesh_b = random_mesh(random, 8, spread, spread);
    const Pose pose = any_rigid_pose(random, spread);
    if (pose.is_translation()) {
      continue;
    }
    const auto root_b = pack({{-16383, -16383, -16383}, {16383, 16383, 16383}});
    RotatedTransform transform{};
    const std::int32_t nowhere[3] = {0, 0, 0};
    REQUIRE(transform.prepare(pose, nowhere, root_b, nowhere, root_b, false));
    for (std::uint32_t t = 0; t < mesh_b.triangles.size(); ++t) {
      const PackedBox box_b = pack(bake::box_of(mesh_b, t));
      for (const std::uint32_t corner : mesh_b.triangles[t]) {
        const Vertex& v = mesh_b.vertices[corner];
        const Point transformed = transform.transform(v);
        REQUIRE(transformed.x == transformed_coordinate(mesh_b, v, pose, 0));
        REQUIRE(transformed.y == transformed_coordinate(mesh_b, v, pose, 1));
        REQUIRE(transformed.z == transformed_coordinate(mesh_b, v, pose, 2));
        if (std::abs(transformed.x) > 16383 || std::abs(transformed.y) > 16383 ||
            std::abs(transformed.z) > 16383) {
          continue;
        }
        // The smallest box of A that the vertex touches: the vertex itself.
        const Vertex at = {static_cast<std::int16_t>(transformed.x),
                           static_cast<std::int16_t>(transformed.y),
                           static_cast<std::int16_t>(transformed.z)};
        const PackedBox box_a = pack({at, at});
        RotatedBoxTest overlap(transform);
        REQUIRE(overlap(box_a, box_b));
        REQUIRE(overlap(box_a, box_b));  // from what it kept
      }
    }
  }
}

TEST_CASE("a transformed vertex is within 0.51 cells of where the pose's numbers put it") {
  Random random = test_random(3);
  for (int round = 0; round < 3000; ++round) {
    const bake::LatticeMesh mesh = random_mesh(random, 1, 16383, 16383);
    const Pose pose = any_rigid_pose(random, 16383);
    for (const Vertex& v : mesh.vertices) {
      for (int axis = 0; axis < 3; ++axis) {
        // 30 fraction bits.
        const std::int64_t exact =
            std::int64_t{pose.rotation(axis, 0)} * v.x +
            std::int64_t{pose.rotation(axis, 1)} * v.y +
            std::int64_t{pose.rotation(axis, 2)} * v.z +
            (std::int64_t{pose.translation(axis)} * 65536 + pose.fraction(axis)) * 16384;
        const std::int64_t transformed =
            transformed_coordinate(mesh, v, pose, axis) * (std::int64_t{1} << 30);
        REQUIRE(std::llabs(transformed - exact) <= (std::int64_t{51} << 30) / 100);
      }
    }
  }
}

TEST_CASE("a quarter turn of boxes is tested as exactly as no turn at all") {
  Random random = test_random(4);
  int overlapping = 0;
  for (int round = 0; round < 3000; ++round) {
    // About z: x goes to y, y to -x.
    const std::int32_t cells[3] = {random.between(-40, 40), random.between(-40, 40),
                                   random.between(-40, 40)};
    const Pose pose = Pose::rigid(rotation_of({1, 0, 0, 1}).entry, cells);
    const bake::LatticeMesh mesh = random_mesh(random, 2, 30, 30);
    const Box a = bake::box_of(mesh, 0);
    const Box b = bake::box_of(mesh, 1);
    const auto negated = [](std::int16_t value) { return static_cast<std::int16_t>(-value); };
    const Box rotated = {{negated(b.upper.y), b.lower.x, b.lower.z},
                         {negated(b.lower.y), b.upper.x, b.upper.z}};
    RotatedTransform transform{};
    const std::int32_t nowhere[3] = {0, 0, 0};
    REQUIRE(transform.prepare(pose, nowhere, pack(a), nowhere, pack(b), false));
    const bool expected =
        !boxes_disjoint(pack(a), pack(rotated), [&](int axis) { return cells[axis]; });
    const PackedBox packed_a = pack(a);
    const PackedBox packed_b = pack(b);
    RotatedBoxTest overlap(transform);
    REQUIRE(overlap(packed_a, packed_b) == expected);
    overlapping += expected ? 1 : 0;
  }
  CHECK(overlapping > 300);
}
