#include "hard_mesh.hpp"

#include "support/points.hpp"

using namespace flashbvh;
using flashbvh::test::coordinate_near;
using flashbvh::test::Random;

namespace bound {
namespace {

Vertex corner(Random& random, Kind kind, const Vertex& centre, const Vertex& first, int32_t reach) {
  switch (kind) {
    case Kind::scattered:
      return {coordinate_near(random, centre.x, reach / 8),
              coordinate_near(random, centre.y, reach / 8),
              coordinate_near(random, centre.z, reach / 8)};
    case Kind::flat:
      return {coordinate_near(random, 0, reach), coordinate_near(random, 0, reach), 0};
    case Kind::points:
      return first;
    default:
      return {coordinate_near(random, 0, reach), coordinate_near(random, 0, reach),
              coordinate_near(random, 0, reach)};
  }
}

/// `reach`: the limit of coordinates, at most kMaxCoordinate.
void make_mesh(Random& random, Kind kind, int32_t reach, digest::SmallMesh& mesh) {
  mesh.triangle_count = static_cast<uint16_t>(1 + random.below(digest::kMostTriangles));
  mesh.vertex_count = 0;
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
    const Vertex centre = {coordinate_near(random, 0, reach), coordinate_near(random, 0, reach),
                           coordinate_near(random, 0, reach)};
    for (uint32_t i = 0; i < 3; ++i) {
      const Vertex& first = i == 0 ? centre : mesh.vertices[mesh.vertex_count - 1];
      const bool doubled = kind == Kind::segments && i == 2;
      mesh.vertices[mesh.vertex_count] =
          doubled ? first : corner(random, kind, centre, first, reach);
      mesh.triangles[t].corner[i] = mesh.vertex_count++;
    }
  }
  for (int32_t& axis : mesh.origin) {
    axis = 0;
  }
}

}  // namespace

bool make_side(Random& random, int32_t reach, Side& side) {
  make_mesh(random, static_cast<Kind>(random.below(kKinds)), reach, side.mesh);
  side.leaf_size = 1 + random.below(3);
  const auto shape = static_cast<digest::Shape>(random.below(4));
  const bool good = side.tree.make(side.mesh, shape, side.leaf_size);
  const auto& tree = side.tree.view();
  side.depth = 0;
  for (uint32_t i = 0; i < tree.node_count; ++i) {
    side.depth = tree.levels[i] > side.depth ? tree.levels[i] : side.depth;
  }
  return good;
}

}  // namespace bound
