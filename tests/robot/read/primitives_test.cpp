// Primitives as meshes: closed, facing outwards, and enclosing the whole primitive.
#include "mesh/defects.hpp"
#include "robot/read/primitive_mesh.hpp"
#include "support/arms/arms.hpp"
#include "support/surface.hpp"
#include "support/test.hpp"

namespace {

/// The least depth of a point under the planes of all triangles: its depth in a convex mesh.
double depth(const bake::SourceMesh& mesh, const Vector3& point) {
  double least = 1e300;
  for (const FloatTriangle& t : triangles_of(mesh)) {
    const Vector3 normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    least = std::min(least, dot(minus(t[0], point), normal) / std::sqrt(squared(normal)));
  }
  return least;
}

/// A point at this distance from the origin.
Vector3 any_point_at(Random& random, double radius) {
  const Vector3 v = any_vector(random, 1);
  return plus({0, 0, 0}, radius / std::sqrt(squared(v)), v);
}

void check_closed(const bake::SourceMesh& mesh) {
  CHECK(tool::edge_defects(mesh.triangles, {}).none());
  CHECK(depth(mesh, {0, 0, 0}) > 0);
}

}  // namespace

TEST_CASE("a box has its edges' lengths") {
  const tool::PrimitiveMesh box = tool::box_mesh({2, 4, 6});
  check_closed(box.mesh);
  CHECK(box.excess == 0);
  CHECK(box.mesh.triangles.size() == 12);
  CHECK(depth(box.mesh, {1, 0, 0}) == 0);
  CHECK(depth(box.mesh, {0, -2, 0}) == 0);
  CHECK(depth(box.mesh, {0, 0, 3}) == 0);
}

TEST_CASE("a cylinder and a sphere lie inside their meshes, which reach no further than they say") {
  Random random = test_random();
  const double radius = 0.7;
  const tool::PrimitiveMesh cylinder = tool::cylinder_mesh(radius, 2);
  const tool::PrimitiveMesh sphere = tool::sphere_mesh(radius);
  check_closed(cylinder.mesh);
  check_closed(sphere.mesh);
  CHECK(cylinder.excess < 0.005 * radius);
  CHECK(sphere.excess < 0.019 * radius);
  for (int i = 0; i < test::rounds(3000, 20000); ++i) {
    const Vector3 v = any_point_at(random, radius);
    const double width = std::hypot(v[0], v[1]);
    CHECK(depth(sphere.mesh, v) >= 0);
    CHECK(depth(cylinder.mesh, {v[0] / width * radius, v[1] / width * radius, 1}) >= 0);
  }
  for (const Vector3& v : sphere.mesh.vertices) {
    CHECK(std::hypot(v[0], v[1], v[2]) < radius + sphere.excess + 1e-12);
  }
  for (const Vector3& v : cylinder.mesh.vertices) {
    CHECK(std::hypot(v[0], v[1]) < radius + cylinder.excess + 1e-12);
    CHECK(std::fabs(v[2]) == 1);
  }
}
