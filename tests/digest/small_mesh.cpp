#include "small_mesh.hpp"

#include "support/points.hpp"

namespace digest {

using namespace flashbvh;
using flashbvh::test::Random;

void make_mesh(Random& random, const Scale& scale, SmallMesh& mesh) {
  mesh.triangle_count = static_cast<uint16_t>(1 + random.below(kMostTriangles));
  mesh.vertex_count = 0;
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
    const Point centre = test::any_point(random, scale.spread);
    for (uint32_t i = 0; i < 3; ++i) {
      const bool shared = mesh.vertex_count > 3 && random.below(3) == 0;
      if (shared) {
        mesh.triangles[t].corner[i] =
            static_cast<uint16_t>(mesh.vertex_count - 1 - random.below(3));
        continue;
      }
      mesh.vertices[mesh.vertex_count] = {test::coordinate_near(random, centre.x, scale.size),
                                          test::coordinate_near(random, centre.y, scale.size),
                                          test::coordinate_near(random, centre.z, scale.size)};
      mesh.triangles[t].corner[i] = mesh.vertex_count++;
    }
  }
  for (int32_t& axis : mesh.origin) {
    axis = random.below(2) == 0 ? 0 : random.between(-scale.reach, scale.reach);
  }
}

Pose any_pose(Random& random, const Scale& scale) {
  if (random.below(4) != 0) {
    return test::any_rigid_pose(random, scale.reach);
  }
  const Point by = test::any_point(random, scale.reach);
  return Pose::translated(by.x, by.y, by.z);
}

}  // namespace digest
