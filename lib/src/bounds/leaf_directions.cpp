// Directions of leaf planes, for tools.
#include "flashbvh/detail/bounds/slab.hpp"
#include "flashbvh/triangle.hpp"

namespace flashbvh {

bool get_leaf_directions(const Vertex (&corners)[3], LeafDirections& directions) noexcept {
  using detail::PackedVector;
  const detail::PackedTriangle triangle = {
      PackedVector::of(corners[0]), PackedVector::of(corners[1]), PackedVector::of(corners[2])};
  PackedVector normal{};
  PackedVector across{};
  const bool has_area = triangle.plane_direction(normal) && triangle.edge_direction(normal, across);
  directions = {{normal.x(), normal.y(), normal.z}, {across.x(), across.y(), across.z}};
  return has_area;
}

}  // namespace flashbvh
