// A query's use of a pose: transformed vertices, box tests that must not miss them, and reported
// pairs transformed again.
#include "bake/baked_tree.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/query.hpp"
#include "support/points.hpp"
#include "support/queries.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"
#include "support/torus.hpp"
#include "support/transformed_mesh.hpp"

using namespace flashbvh::detail;

namespace {

using Pair = PairQuery::Pair;
using flashbvh::test::same;

Baked<Layout::post_indexed> baked(const bake::LatticeMesh& mesh) {
  return bake::lay_out<std::uint16_t, Layout::post_indexed>(bake::build_median(mesh, 3), mesh);
}

bake::LatticeMesh ring() {
  bake::LatticeMesh mesh = torus(8, 6, 600, 250);
  mesh.origin = {1000, -200, 30};
  return mesh;
}

/// The number of reported pairs; the sink transforms each again like the query.
std::uint32_t check_pairs(const Mesh& a, const Mesh& b, const Pose& pose) {
  PairQuery query(a, b, pose);
  std::uint32_t pairs = 0;
  std::uint32_t wrong = 0;
  const RunResult step = query.run(UINT32_MAX, [&](const Pair& pair) {
    Triangle last[2];
    Triangle again[2];
    query.last_pair(last[0], last[1]);
    const bool found = transform_pair(a, b, pose, pair, again[0], again[1]);
    const bool equal = found && same(last[0], again[0]) && same(last[1], again[1]) &&
                       same_place(contact_of_last(query), contact_of(again[0], again[1]));
    wrong += equal ? 0u : 1u;
    ++pairs;
    return true;
  });
  CHECK(step.status == Status::done);
  CHECK(wrong == 0);
  return pairs;
}

}  // namespace

TEST_CASE("no box test rejects boxes with a transformed vertex of one in the other") {
  for_rounds(rounds(600, 3000), 2, [&](Random& random, int round) {
    const std::int32_t spread = round % 3 == 0 ? 16383 : round % 3 == 1 ? 400 : 12;
    bake::LatticeMesh mesh_b = random_mesh(random, 8, spread, spread);
    const Pose pose = any_rigid_pose(random, spread);
    if (pose.is_translation()) {
      return;
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
        // The smallest box of A that touches the vertex is the vertex itself.
        const Vertex at = {static_cast<std::int16_t>(transformed.x),
                           static_cast<std::int16_t>(transformed.y),
                           static_cast<std::int16_t>(transformed.z)};
        const PackedBox box_a = pack({at, at});
        RotatedBoxTest overlap(transform);
        REQUIRE(overlap(box_a, box_b));
        REQUIRE(overlap(box_a, box_b));  // from the kept box
      }
    }
  });
}

TEST_CASE("a transformed vertex is within 0.51 cells of where the pose's numbers put it") {
  for_rounds(3000, 3, [&](Random& random, int) {
    const bake::LatticeMesh mesh = random_mesh(random, 1, 16383, 16383);
    const Pose pose = any_rigid_pose(random, 16383);
    for (const Vertex& v : mesh.vertices) {
      for (int axis = 0; axis < 3; ++axis) {
        // With 30 fraction bits.
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
  });
}

TEST_CASE("a quarter turn of boxes is tested as exactly as no turn at all") {
  int overlapping = 0;
  for_rounds(3000, 4, [&](Random& random, int) {
    // Turns about z: x goes to y, y to -x.
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
  });
  CHECK(overlapping > 300);
}

TEST_CASE("contact: a reported pair is transformed again as the query had it", "[contact]") {
  const auto mesh_a = baked(ring());
  const auto mesh_b = baked(torus(7, 5, 500, 200));
  const Mesh a = mesh_a.view();
  const Mesh b = mesh_b.view();
  CHECK(check_pairs(a, b, Pose::translated(1300, 100, 200)) > 10);
  const Rotation rotation = rotation_of({3, 1, 2, -1});
  const std::int32_t cells[3] = {1400, 50, 100};
  CHECK(check_pairs(a, b, Pose::rigid(rotation.entry, cells)) > 10);
}

TEST_CASE(
    "contact: a pair is transformed to where the pose's definition puts it, intersecting or not",
    "[contact]") {
  const bake::LatticeMesh mesh_a = ring();
  const bake::LatticeMesh mesh_b = torus(7, 5, 500, 200);
  const auto baked_a = baked(mesh_a);
  const auto baked_b = baked(mesh_b);
  const Mesh a = baked_a.view();
  const Mesh b = baked_b.view();
  const Rotation rotation = rotation_of({3, 1, 2, -1});
  const std::int32_t cells[3] = {9000, 50, 100};  // far from A
  const Pose pose = Pose::rigid(rotation.entry, cells);
  for (std::uint16_t i = 0; i < b.triangle_count; ++i) {
    Triangle transformed_a;
    Triangle transformed_b;
    REQUIRE(transform_pair(a, b, pose, {0, i}, transformed_a, transformed_b));
    CHECK(same(transformed_b, transformed(mesh_b, i, pose)));
  }
}

TEST_CASE("contact: a pair that no query reports is refused", "[contact]") {
  const auto baked_a = baked(ring());
  const Mesh a = baked_a.view();
  Mesh b = a;
  const Pose pose = Pose::translated(0, 0, 0);
  const auto count = a.triangle_count;
  const auto last = static_cast<std::uint16_t>(count - 1);
  Triangle transformed[2];
  CHECK(transform_pair(a, b, pose, {last, last}, transformed[0], transformed[1]));
  CHECK_FALSE(transform_pair(a, b, pose, {count, 0}, transformed[0], transformed[1]));
  CHECK_FALSE(transform_pair(a, b, pose, {0, count}, transformed[0], transformed[1]));
  CHECK_FALSE(transform_pair(a, b, Pose::translated(INT32_MAX, 0, 0), {0, 0}, transformed[0],
                             transformed[1]));
  b.cell_bits ^= 1;
  CHECK_FALSE(transform_pair(a, b, pose, {0, 0}, transformed[0], transformed[1]));
}
