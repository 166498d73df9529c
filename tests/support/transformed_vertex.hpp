// Which triangles intersect under a pose, by trying all pairs of them.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/predicates/triangle.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "reference/transformed_coordinate.hpp"

namespace flashbvh::test {

/// Corner `i` of a triangle's three vertex numbers, however they are kept.
template <class Index>
constexpr uint32_t corner_of(const Corners<Index>& triangle, uint32_t i) {
  return triangle.corner[i];
}
template <class Array>
constexpr uint32_t corner_of(const Array& triangle, uint32_t i) {
  return triangle[i];
}

/// A triangle of B in A's frame. Mesh: has an origin, vertices and triangles.
template <class Mesh>
Triangle transformed(const Mesh& mesh, uint32_t triangle, const Pose& pose) {
  Triangle transformed{};
  for (uint32_t i = 0; i < 3; ++i) {
    const Vertex& v = mesh.vertices[corner_of(mesh.triangles[triangle], i)];
    transformed.corner[i] = {transformed_coordinate(&mesh.origin[0], v, pose, 0),
                             transformed_coordinate(&mesh.origin[0], v, pose, 1),
                             transformed_coordinate(&mesh.origin[0], v, pose, 2)};
  }
  return transformed;
}

/// Calls found(i, j) for each two triangles that intersect, of the first `count_a` and `count_b`.
template <class Mesh, class Found>
void brute_force(const Mesh& a, uint32_t count_a, const Mesh& b, uint32_t count_b, const Pose& pose,
                 const Found& found) {
  const Pose here = Pose::translated(0, 0, 0);
  for (uint32_t i = 0; i < count_a; ++i) {
    const Triangle of_a = transformed(a, i, here);
    for (uint32_t j = 0; j < count_b; ++j) {
      if (detail::triangles_intersect(of_a, transformed(b, j, pose))) {
        found(i, j);
      }
    }
  }
}

/// As queries of distance place B.
template <class Mesh>
detail::Transform transform_of_any(const Pose& pose, const Mesh& a, const Mesh& b) {
  detail::Transform transform(pose, a, b, /*may_stop=*/false);
  if (!transform.is_near()) {
    transform.place_far(pose, a.origin, b.origin);
  }
  return transform;
}

/// Every pair of triangles of two meshes, as a query has them: by the library's transform.
/// `visit(i, j, of_a, of_b)`: by their positions, in A's lattice.
template <class Mesh, class Visit>
void for_all_pairs(const Mesh& a, const Mesh& b, const detail::Transform& transform,
                   const Visit& visit) {
  for (uint32_t i = 0; i < a.triangle_count; ++i) {
    Triangle of_a;
    detail::translate_triangle(a, i, detail::kNoOffset, of_a);
    for (uint32_t j = 0; j < b.triangle_count; ++j) {
      Triangle of_b;
      detail::transform_any_triangle(b, j, transform, of_b);
      visit(i, j, of_a, of_b);
    }
  }
}

}  // namespace flashbvh::test
