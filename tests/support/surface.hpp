// Surfaces of meshes before baking, in doubles: triangles, random points, distances by brute force.
#pragma once

#include <cmath>
#include <vector>

#include "bake/mesh.hpp"
#include "support/oracles/float_distance.hpp"
#include "support/random.hpp"

namespace flashbvh::test {

inline std::vector<FloatTriangle> triangles_of(const bake::SourceMesh& mesh) {
  std::vector<FloatTriangle> triangles;
  for (const auto& [p, q, r] : mesh.triangles) {
    triangles.push_back({mesh.vertices[p], mesh.vertices[q], mesh.vertices[r]});
  }
  return triangles;
}

/// A random point of a triangle. Corners and edges matter most: a quarter of the points each.
inline FloatVector any_point_of(Random& random, const FloatTriangle& of) {
  double s = random.below(4) == 0 ? 0 : random.below(1001) / 1000.0;
  double t = random.below(4) == 0 ? 0 : random.below(1001) / 1000.0;
  if (s + t > 1) {
    s = 1 - s;
    t = 1 - t;
  }
  return plus(plus(plus({0, 0, 0}, 1 - s - t, of[0]), s, of[1]), t, of[2]);
}

/// A random point of a mesh; all triangles are equally likely.
inline FloatVector any_point_of(Random& random, const bake::SourceMesh& mesh) {
  const std::uint32_t number = random.below(static_cast<std::uint32_t>(mesh.triangles.size()));
  const auto& [p, q, r] = mesh.triangles[number];
  return any_point_of(random, {mesh.vertices[p], mesh.vertices[q], mesh.vertices[r]});
}

/// The distance of a point from a mesh, by testing each triangle.
inline double distance_by_force(const FloatVector& p, const bake::SourceMesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for (const FloatTriangle& triangle : triangles_of(mesh)) {
    least = std::min(least, squared_distance(p, triangle));
  }
  return std::sqrt(least);
}

}  // namespace flashbvh::test
