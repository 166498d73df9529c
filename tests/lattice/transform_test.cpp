// A query's use of a pose: transformed vertices, and reported pairs transformed again.
#include "flashbvh/contact.hpp"
#include "support/any_mesh.hpp"
#include "support/points.hpp"
#include "support/test.hpp"
#include "support/torus.hpp"

using namespace flashbvh::detail;

TEST_CASE("a transformed vertex is within 0.51 cells of where the pose's numbers put it") {
  for_rounds(3000, 3, [&](Random& random, int) {
    const bake::LatticeMesh mesh = random_mesh(random, 1, 16383, 16383);
    const Pose pose = any_rigid_pose(random, 16383);
    for (const Vertex& v : mesh.vertices) {
      const Point at = transformed(mesh, v, pose);
      for (int axis = 0; axis < 3; ++axis) {
        // With 30 fraction bits.
        const std::int64_t exact =
            std::int64_t{pose.rotation(axis, 0)} * v.x +
            std::int64_t{pose.rotation(axis, 1)} * v.y +
            std::int64_t{pose.rotation(axis, 2)} * v.z +
            (std::int64_t{pose.translation(axis)} * 65536 + pose.fraction(axis)) * 16384;
        const std::int64_t along = at.*kPointAxes[axis] * (std::int64_t{1} << 30);
        REQUIRE(std::llabs(along - exact) <= (std::int64_t{51} << 30) / 100);
      }
    }
  });
}

TEST_CASE("contact: a pair that no query reports is refused", "[contact]") {
  const bake::LatticeMesh ring = torus(8, 6, 600, 250);
  const AnyMesh any(bake::build_median(ring, 3), ring);
  const Mesh& a = any;
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
