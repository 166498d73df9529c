#include "small_mesh.hpp"

namespace digest {

using namespace flashbvh;
using flashbvh::test::Random;

namespace {

int16_t coordinate(Random& random, int32_t centre, int32_t reach) {
  const int32_t value = centre + random.between(-reach, reach);
  return static_cast<int16_t>(value > kMaxCoordinate    ? kMaxCoordinate
                              : value < -kMaxCoordinate ? -kMaxCoordinate
                                                        : value);
}

}  // namespace

void make_mesh(Random& random, const Scale& scale, SmallMesh& mesh) {
  mesh.triangle_count = static_cast<uint16_t>(1 + random.below(kMostTriangles));
  mesh.vertex_count = 0;
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
    const int32_t x = random.between(-scale.spread, scale.spread);
    const int32_t y = random.between(-scale.spread, scale.spread);
    const int32_t z = random.between(-scale.spread, scale.spread);
    for (uint32_t i = 0; i < 3; ++i) {
      const bool shared = mesh.vertex_count > 3 && random.below(3) == 0;
      if (shared) {
        mesh.triangles[t].corner[i] =
            static_cast<uint16_t>(mesh.vertex_count - 1 - random.below(3));
        continue;
      }
      const int16_t vx = coordinate(random, x, scale.size);
      const int16_t vy = coordinate(random, y, scale.size);
      const int16_t vz = coordinate(random, z, scale.size);
      mesh.vertices[mesh.vertex_count] = {vx, vy, vz};
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
  const int32_t x = random.between(-scale.reach, scale.reach);
  const int32_t y = random.between(-scale.reach, scale.reach);
  const int32_t z = random.between(-scale.reach, scale.reach);
  return Pose::translated(x, y, z);
}

}  // namespace digest
