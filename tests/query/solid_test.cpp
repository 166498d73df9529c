// Inside and outside: winding numbers against solid angles, and bodies against both.
#include "flashbvh/solid.hpp"
#include "support/any_mesh.hpp"
#include "support/boxes.hpp"
#include "support/test.hpp"
#include "support/torus.hpp"

namespace {

/// The side of a point in A's lattice, by solid angles.
PointSide truth_of(const Mesh& mesh, const detail::Transform* transform, const Point& p) {
  const Winding winding = winding_about(mesh, p, transform);
  return winding.on_surface    ? PointSide::on_surface
         : winding.number != 0 ? PointSide::inside
                               : PointSide::outside;
}

/// A mesh that must be closed.
AnyMesh closed(Random& random, const bake::LatticeMesh& lattice) {
  AnyMesh mesh = any_mesh(random, lattice);
  REQUIRE(mesh.is_closed);
  return mesh;
}

/// A closed box about the origin.
bake::LatticeMesh small_box() {
  bake::LatticeMesh box;
  add_box(box, {-10, -10, -10}, {20, 20, 20}, false);
  return box;
}

}  // namespace

TEST_CASE(
    "a point's side is decided by its winding number, wherever edges and corners lie above it") {
  std::uint32_t seen[3] = {0, 0, 0};
  const std::uint32_t tries = rounds(24u, 60u);
  for_rounds(tries, [&](Random& random, std::uint32_t) {
    bake::LatticeMesh lattice = boxes(random);
    for (std::int32_t& origin : lattice.origin) {
      origin = random.between(-1000, 1000);
    }
    const AnyMesh mesh = closed(random, lattice);
    for (std::int32_t x = -5; x <= 9; ++x) {
      for (std::int32_t y = -5; y <= 9; ++y) {
        for (std::int32_t z = -5; z <= 9; z += 1 + static_cast<std::int32_t>(random.below(2))) {
          const Point p = {x, y, z};
          const PointSide truth = truth_of(mesh, nullptr, p);
          const PointAnswer found =
              inside(mesh, {x + mesh.origin[0], y + mesh.origin[1], z + mesh.origin[2]});
          CAPTURE(x, y, z);
          REQUIRE(found.status == Status::done);
          REQUIRE(found.side == truth);
          REQUIRE(found.visits <= mesh.node_count);
          ++seen[static_cast<int>(found.side)];
        }
      }
    }
  });
  CHECK((seen[0] > tries && seen[1] > tries && seen[2] > tries));
}

TEST_CASE("below the edges and corners of a curved mesh no crossing is lost") {
  const bake::LatticeMesh lattice = torus(24, 16, 8000, 3000);
  const AnyMesh mesh(bake::build_default(lattice), lattice);
  std::uint32_t within = 0;
  for_rounds(1500, [&](Random& random, int round) {
    // Just below a corner, or below the middle of an edge.
    const auto& corner = mesh.triangles[random.below(mesh.triangle_count)].corner;
    const Vertex& u = mesh.vertices[corner[0]];
    const Vertex& v = mesh.vertices[corner[round % 2 == 0 ? 0 : 1]];
    const Point p = {(u.x + v.x) / 2, (u.y + v.y) / 2, random.between(-4000, 4000)};
    const PointAnswer found = inside(mesh, p);
    REQUIRE(found.side == truth_of(mesh, nullptr, p));
    within += found.side == PointSide::inside ? 1 : 0;
  });
  CHECK(within > 100);
  CHECK(inside(mesh, {0, 0, 0}).side == PointSide::outside);
  CHECK(inside(mesh, {8000, 0, 0}).side == PointSide::inside);
  CHECK(inside(mesh, {1 << 29, 0, -(1 << 29)}).side == PointSide::outside);
  CHECK(inside(mesh, {8000, 0, 0}).visits < 200);
  CHECK(inside(mesh, {8000, 0, 3001}).visits == 1);  // just above the mesh, and next to it
  CHECK(inside(mesh, {11001, 0, 0}).visits == 1);
  CHECK(inside(mesh, {-11001, 0, 0}).visits == 1);
  CHECK(inside(mesh, {0, 11001, 0}).visits == 1);
  CHECK(inside(mesh, {0, -11001, 0}).visits == 1);
}

TEST_CASE("bodies have points in common if triangles intersect or one lies inside the other") {
  std::uint32_t within = 0;
  std::uint32_t apart = 0;
  for_rounds(400, [&](Random& random, int) {
    bake::LatticeMesh outer;
    const std::int32_t wide = random.between(20, 60);
    add_box(outer, {-wide, -wide, -wide}, {2 * wide, 2 * wide, 2 * wide}, false);
    if (random.below(2) == 0) {  // hollow, sometimes with a body in the middle
      add_box(outer, {3 - wide, 3 - wide, 3 - wide}, {2 * wide - 6, 2 * wide - 6, 2 * wide - 6},
              true);
    }
    bake::LatticeMesh inner;
    add_box(inner, {-4, -5, -6}, {8, 9, 7}, random.below(2) == 0);
    if (random.below(3) == 0) {
      add_box(inner, {40, 0, 0}, {5, 5, 5}, false);
    }
    const AnyMesh a = closed(random, outer);
    const AnyMesh b = closed(random, inner);
    const Pose pose = any_pose(random, 90);
    detail::Transform transform(pose, a, b, /*may_stop=*/false);
    bool truth = intersects(a, b, pose).yes;
    const bool touch = truth;
    for (std::uint32_t i = 0; i < b.vertex_count && !truth; ++i) {
      const Point p = transformed<Mesh>(b, b.vertices[i], pose);
      truth = truth_of(a, nullptr, p) != PointSide::outside;
    }
    for (std::uint32_t i = 0; i < a.vertex_count && !truth; ++i) {
      const Vertex& v = a.vertices[i];
      truth = truth_of(b, &transform, {v.x, v.y, v.z}) != PointSide::outside;
    }
    const Answer found = solids_intersect(a, b, pose);
    REQUIRE(found.status == Status::done);
    REQUIRE(found.yes == truth);
    const Answer other_way = solids_intersect(b, a, pose.inverse());
    REQUIRE(other_way.status == Status::done);
    REQUIRE((!pose.is_translation() || other_way.yes == truth));
    // The part that a query without intersecting pairs leaves open.
    const Answer contained = one_is_inside(a, b, pose);
    REQUIRE(contained.status == Status::done);
    REQUIRE((touch || contained.yes == truth));
    within += truth && !touch ? 1 : 0;
    apart += truth ? 0 : 1;
  });
  CHECK((within > 10 && apart > 20));
}

TEST_CASE("bodies at the ends of the range have nothing in common") {
  Random random = test_random();
  bake::LatticeMesh box = small_box();
  box.origin = {1 << 29, -(1 << 29), 1 << 29};
  const AnyMesh a = closed(random, box);
  box.origin = {-(1 << 29), 1 << 29, -(1 << 29)};
  const AnyMesh b = closed(random, box);
  const std::int32_t most = kMaxTranslation;
  const Pose poses[] = {Pose::translated(0, 0, 0), Pose::translated(-most, most, -most),
                        any_pose(random, most), any_pose(random, 10)};
  for (const Pose& pose : poses) {
    CHECK(one_is_inside(a, b, pose).status == Status::done);
    CHECK_FALSE(one_is_inside(a, b, pose).yes);
    CHECK_FALSE(one_is_inside(b, a, pose).yes);
    CHECK_FALSE(solids_intersect(a, b, pose).yes);
  }
}

TEST_CASE("an open mesh has no inside") {
  Random random = test_random();
  bake::LatticeMesh box = small_box();
  const AnyMesh b = closed(random, box);
  box.triangles.pop_back();
  const AnyMesh a = any_mesh(random, box);
  CHECK(inside(a, {0, 0, 0}).status == Status::not_closed);
  CHECK(inside(a, {0, 0, 0}).side == PointSide::inside);
  const Pose apart = Pose::translated(100, 0, 0);
  CHECK(solids_intersect(a, b, apart).status == Status::not_closed);
  CHECK(solids_intersect(b, a, apart).yes);
  CHECK_FALSE(solids_intersect(b, b, apart).yes);
  CHECK(one_is_inside(a, b, apart).status == Status::not_closed);
  CHECK(one_is_inside(b, a, apart).status == Status::not_closed);
  CHECK(one_is_inside(b, a, apart).yes);
  CHECK(one_is_inside(b, b, apart).status == Status::done);
  CHECK_FALSE(one_is_inside(b, b, apart).yes);
}

TEST_CASE("calls after a query refuse what the query refuses") {
  Random random = test_random();
  const AnyMesh a = closed(random, small_box());
  Mesh other_cell = a;
  other_cell.cell_bits ^= 1;
  const Pose apart = Pose::translated(100, 0, 0);
  const Pose nowhere = Pose::translated(INT32_MAX, 0, 0);
  CHECK(one_is_inside(a, other_cell, apart).status == Status::cell_mismatch);
  CHECK(one_is_inside(a, other_cell, apart).yes);
  CHECK(one_is_inside(a, a, nowhere).status == Status::translation_out_of_range);
  CHECK(one_is_inside(a, a, nowhere).yes);
  CHECK(solids_intersect(a, other_cell, apart).status == Status::cell_mismatch);
}
