// Triangles under a pose, and the pairs that intersect, by brute force.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/predicates/triangle.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"

namespace flashbvh::test {

/// The quotient, rounded down.
constexpr int64_t floor_divide(int64_t value, int64_t by) {
  return value / by - (value % by < 0 ? 1 : 0);
}

/// Coordinate `axis` of a vertex of B in A's frame: floor(R p + o + 1/2), where R has 22 fraction
/// bits, o has 14, and the sum of products is rounded down to 14. `origin`: B's.
inline int32_t transformed_coordinate(const int32_t* origin, const Vertex& v, const Pose& pose,
                                      int axis) {
  const int32_t p[3] = {v.x, v.y, v.z};
  int64_t offset =
      pose.translation(axis) * (int64_t{1} << 30) + pose.fraction(axis) * (int64_t{1} << 14);
  int64_t rotated = 0;
  for (int i = 0; i < 3; ++i) {
    const int64_t entry = pose.rotation(axis, i);
    offset += entry * origin[i];
    rotated += floor_divide(entry + 128, 256) * p[i];
  }
  const int64_t sum = floor_divide(rotated, 256) + floor_divide(offset + 32768, 65536);
  return static_cast<int32_t>(floor_divide(sum + 8192, 16384));
}

/// The vertex number of a triangle's corner `i`, from either representation.
template <class Index>
constexpr uint32_t corner_of(const Corners<Index>& triangle, uint32_t i) {
  return triangle.corner[i];
}
template <class Array>
constexpr uint32_t corner_of(const Array& triangle, uint32_t i) {
  return triangle[i];
}

/// A vertex of B in A's frame. Mesh: has an origin.
template <class Mesh>
Point transformed(const Mesh& mesh, const Vertex& v, const Pose& pose) {
  const auto at = [&](int axis) { return transformed_coordinate(&mesh.origin[0], v, pose, axis); };
  return {at(0), at(1), at(2)};
}

/// A triangle of B in A's frame. Mesh: has an origin, vertices and triangles.
template <class Mesh>
Triangle transformed(const Mesh& mesh, uint32_t triangle, const Pose& pose) {
  const auto at = [&](uint32_t i) {
    return transformed(mesh, mesh.vertices[corner_of(mesh.triangles[triangle], i)], pose);
  };
  return {{at(0), at(1), at(2)}};
}

/// Calls visit(i, j, of_a, of_b) for each pair of the first `count_a` and `count_b` triangles, in
/// A's frame.
template <class Mesh, class Visit>
void for_all_pairs(const Mesh& a, uint32_t count_a, const Mesh& b, uint32_t count_b,
                   const Pose& pose, const Visit& visit) {
  const Pose here = Pose::translated(0, 0, 0);
  for (uint32_t i = 0; i < count_a; ++i) {
    const Triangle of_a = transformed(a, i, here);
    for (uint32_t j = 0; j < count_b; ++j) {
      visit(i, j, of_a, transformed(b, j, pose));
    }
  }
}

/// Calls found(i, j) for each of these pairs that intersects.
template <class Mesh, class Found>
void brute_force(const Mesh& a, uint32_t count_a, const Mesh& b, uint32_t count_b, const Pose& pose,
                 const Found& found) {
  for_all_pairs(a, count_a, b, count_b, pose,
                [&](uint32_t i, uint32_t j, const Triangle& of_a, const Triangle& of_b) {
                  if (detail::triangles_intersect(of_a, of_b)) {
                    found(i, j);
                  }
                });
}

}  // namespace flashbvh::test
