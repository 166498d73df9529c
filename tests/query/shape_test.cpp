// Shapes made at run time, queried like meshes: against equal baked meshes, and formulas.
#include "flashbvh/shape.hpp"
#include "flashbvh/clearance.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/ray.hpp"
#include "flashbvh/solid.hpp"
#include "support/any_mesh.hpp"
#include "support/boxes.hpp"
#include "support/points.hpp"
#include "support/refused.hpp"
#include "support/test.hpp"

namespace {

/// The shape's triangles, baked.
AnyMesh baked(const Mesh& shape) {
  bake::LatticeMesh mesh;
  mesh.vertices.assign(shape.vertices, shape.vertices + shape.vertex_count);
  for (std::uint32_t i = 0; i < shape.triangle_count; ++i) {
    const auto& corner = shape.triangles[i].corner;
    mesh.triangles.push_back({corner[0], corner[1], corner[2]});
  }
  std::copy(shape.origin, shape.origin + 3, mesh.origin.begin());
  return AnyMesh(bake::build_median(mesh, 1), mesh);
}

void compare(const Mesh& mesh, const Mesh& shape, const Pose& pose) {
  const AnyMesh same = baked(shape);
  CHECK(shape.longest_edge >= same.longest_edge);
  CHECK((shape.is_closed == (shape.triangle_count > 1) && (!shape.is_closed || same.is_closed)));
  CHECK(count_pairs(mesh, shape, pose).count == count_pairs(mesh, same, pose).count);
  CHECK(count_pairs(shape, mesh, pose).count == count_pairs(same, mesh, pose).count);
  const auto found = distance(mesh, shape, pose);
  CHECK(found.status == Status::done);
  CHECK(found.lower == distance(mesh, same, pose).lower);
  CHECK(distance(shape, mesh, pose).lower == distance(same, mesh, pose).lower);
  CHECK(closer_than(mesh, shape, pose, {found.upper}).yes);
  CHECK((found.lower == 0 || !closer_than(mesh, shape, pose, {found.lower - 1}).yes));
}

}  // namespace

TEST_CASE("corners sqrt(2) cells apart are within each longer length in the mesh's unit") {
  Random random = test_random();
  const AnyMesh like = any_mesh(random, 30, 200, 60);
  const TriangleShape a(like, {{{0, 0, 0}, {1000, 0, 0}, {0, 1000, 0}}});
  const TriangleShape b(like, {{{-1, -1, 0}, {-1001, -1, 0}, {-1, -1001, 0}}});
  const auto within = [&](float length) {
    return closer_than(a.mesh(), b.mesh(), Pose::translated(0, 0, 0),
                       fine_length_rounded_up(length, 1))
        .yes;
  };
  for (const float length : {1.4143f, 1.4155f, 1.4179f, 1.418f}) {
    CHECK(within(length));
  }
  CHECK_FALSE(within(1.414f));
}

TEST_CASE("shapes are queried like the same triangles, baked") {
  for_rounds(60, [&](Random& random, int) {
    const AnyMesh mesh = any_mesh(random, 30, 200, 60);
    const Pose pose = any_pose(random, 150);
    const Point p = any_point(random, 300);
    const Point q = any_point(random, 300);
    const Point r = any_point(random, 300);
    compare(mesh, PointShape(mesh, p).mesh(), pose);
    compare(mesh, SegmentShape(mesh, p, q).mesh(), pose);
    compare(mesh, TriangleShape(mesh, {{p, q, r}}).mesh(), pose);
    const Point lower = {std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)};
    const Point upper = {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)};
    const BoxShape box(mesh, lower, upper);
    compare(mesh, box.mesh(), pose);
    // The box is closed and faces outwards.
    const Point middle = {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
    CHECK(inside(box.mesh(), middle).side != PointSide::outside);
    CHECK(inside(box.mesh(), {upper.x + 1, middle.y, middle.z}).side == PointSide::outside);
    CHECK(inside(box.mesh(), lower).side == PointSide::on_surface);
    if (inside(box.mesh(), middle).side == PointSide::inside) {
      CHECK(signed_crossings(box.mesh(), {middle, {upper.x + 1, p.y, p.z}}).outwards == 1);
    }
  });
}

TEST_CASE("a sphere and a capsule are a point and a segment with a radius") {
  Random random = test_random();
  const AnyMesh like = any_mesh(random, random_mesh(random, 1, 10, 10));
  const PointShape origin(like, {0, 0, 0});
  const Pose still = Pose::translated(0, 0, 0);
  PointShape point(like, {0, 0, 0});
  SegmentShape segment(like, {0, 0, 0}, {0, 0, 0});
  for (int round = 0; round < 200; ++round) {
    const Point p = any_point(random, 12000);
    point.set(p);
    const double apart = 256 * length_of(vector_of<double>(p));
    CHECK(distance(origin.mesh(), point.mesh(), still).lower == static_cast<std::uint32_t>(apart));
    // A segment along x, past the origin.
    segment.set({-16000, p.y, p.z}, {16000, p.y, p.z});
    const double beside = 256 * std::hypot(p.y, p.z);
    CHECK(distance(origin.mesh(), segment.mesh(), still).lower ==
          static_cast<std::uint32_t>(beside));
  }
}

TEST_CASE("a shape that no mesh can be says so, and keeps its points for rays") {
  Random random = test_random();
  const AnyMesh like = any_mesh(random, random_mesh(random, 1, 10, 10));
  SegmentShape segment(like, {1 << 29, 0, 0}, {(1 << 29) - 32766, 5, 5});
  CHECK(segment.status() == Status::done);
  CHECK(segment.mesh().origin[0] == (1 << 29) - 16383);
  segment.set({0, 0, 0}, {32767, 0, 0});
  CHECK(segment.status() == Status::shape_too_large);
  CHECK(segment.mesh().origin[0] == (1 << 29) - 16383);
  constexpr std::int32_t most = 1 << 29;
  const struct {
    Point from, to;
    Status status;
  } rows[] = {{{INT32_MAX, 0, 0}, {INT32_MAX, 0, 0}, Status::shape_too_large},
              {{0, INT32_MIN, 0}, {0, INT32_MIN, 1}, Status::shape_too_large},
              {{0, 0, INT32_MIN}, {0, 0, INT32_MAX}, Status::shape_too_large},
              {{most, most, most}, {most, most, most}, Status::done},
              {{most + 1, 0, 0}, {most + 1, 0, 0}, Status::shape_too_large},
              {{-most, -most, -most}, {-most, -most, -most}, Status::done},
              {{0, -most - 1, 0}, {0, -most - 1, 0}, Status::shape_too_large},
              {{0, 0, 0}, {0, 0, 1}, Status::done}};
  for (const auto& row : rows) {
    segment.set(row.from, row.to);
    CHECK(segment.status() == row.status);
  }
  CHECK(segment.mesh().longest_edge >= 1);
}

TEST_CASE("queries of a shape that does not fit are refused, until it does") {
  Random random = test_random();
  bake::LatticeMesh box;
  add_box(box, {-10, -10, -10}, {20, 20, 20}, false);
  const AnyMesh mesh = any_mesh(random, box);
  const Pose still = Pose::translated(0, 0, 0);
  constexpr Point far = {INT32_MAX, INT32_MAX, INT32_MAX};
  const auto is_refused = [&](const Mesh& shape) {
    return are_refused(mesh, shape) && are_refused(shape, mesh) &&
           inside(shape, {100, 0, 0}).status == Status::not_closed;
  };
  CHECK(is_refused(PointShape(mesh, far).mesh()));
  CHECK(is_refused(SegmentShape(mesh, {0, 0, 0}, {32768, 0, 0}).mesh()));
  CHECK(is_refused(TriangleShape(mesh, {{far, far, far}}).mesh()));
  BoxShape zone(mesh, {0, 0, 0}, far);
  CHECK(zone.status() == Status::shape_too_large);
  CHECK(is_refused(zone.mesh()));
  zone.set({-1, -1, -1}, far);
  CHECK(is_refused(zone.mesh()));
  zone.set({-1, -1, -1}, {1, 1, 1});
  CHECK_FALSE(is_refused(zone.mesh()));
  CHECK(zone.mesh().cell_bits == mesh.cell_bits);
  CHECK(zone.mesh().is_closed);
  CHECK_FALSE(intersects(mesh, zone.mesh(), still).yes);
  CHECK(solids_intersect(mesh, zone.mesh(), still).status == Status::done);
  CHECK(solids_intersect(mesh, zone.mesh(), still).yes);
  // Set to a place that does not fit, it is no longer at the place before.
  zone.set({-1, -1, -1}, far);
  CHECK(is_refused(zone.mesh()));
  CHECK(any_hit(zone.mesh(), {{-9, 0, 0}, {9, 0, 0}}).yes);
  zone.set({-1, -1, -1}, {1, 1, 1});
  CHECK_FALSE(is_refused(zone.mesh()));
  // Nor do queries take two shapes that do not fit, or one and itself.
  const PointShape point(mesh, far);
  const SegmentShape segment(mesh, {0, 0, 0}, {40000, 0, 0});
  CHECK(are_refused(segment.mesh(), point.mesh()));
  CHECK(are_refused(point.mesh(), point.mesh()));
}
