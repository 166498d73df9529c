#include "hard_mesh.hpp"

#include "flashbvh/detail/walk/level_parts.hpp"

using namespace flashbvh;
using flashbvh::test::Random;

namespace bound {
namespace {

int16_t coordinate(Random& random, int32_t centre, int32_t reach) {
  const int32_t value = centre + random.between(-reach, reach);
  return static_cast<int16_t>(value > kMaxCoordinate    ? kMaxCoordinate
                              : value < -kMaxCoordinate ? -kMaxCoordinate
                                                        : value);
}

Vertex corner(Random& random, Kind kind, const Vertex& centre, const Vertex& first, int32_t reach) {
  switch (kind) {
    case Kind::scattered:
      return {coordinate(random, centre.x, reach / 8), coordinate(random, centre.y, reach / 8),
              coordinate(random, centre.z, reach / 8)};
    case Kind::flat:
      return {coordinate(random, 0, reach), coordinate(random, 0, reach), 0};
    case Kind::points:
      return first;
    default:
      return {coordinate(random, 0, reach), coordinate(random, 0, reach),
              coordinate(random, 0, reach)};
  }
}

/// `reach`: the limit of coordinates, at most kMaxCoordinate.
void make_mesh(Random& random, Kind kind, int32_t reach, digest::SmallMesh& mesh) {
  mesh.triangle_count = static_cast<uint16_t>(1 + random.below(digest::kMostTriangles));
  mesh.vertex_count = 0;
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
    const Vertex centre = {coordinate(random, 0, reach), coordinate(random, 0, reach),
                           coordinate(random, 0, reach)};
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
  side.tree.make(side.mesh, static_cast<digest::Shape>(random.below(4)), side.leaf_size);
  detail::TreeShape shape;
  const bool good = detail::check_tree(side.tree.view(), shape) == Status::done;
  side.depth = shape.depth;
  return good;
}

}  // namespace bound
