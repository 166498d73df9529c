#include "robot/bounding_sphere.hpp"

#include <cmath>

namespace flashbvh::tool {
namespace {

using Point = std::array<double, 3>;

Point vertex_of(const PostMesh& mesh, std::uint32_t i) {
  const Vertex& vertex = mesh.vertices[i];
  return {static_cast<double>(mesh.origin[0]) + vertex.x,
          static_cast<double>(mesh.origin[1]) + vertex.y,
          static_cast<double>(mesh.origin[2]) + vertex.z};
}

double distance(const Point& p, const Point& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace

BoundingSphere bounding_sphere(const PostMesh& mesh) {
  constexpr int steps = 200;
  Point centre = vertex_of(mesh, 0);
  for (int step = 1; step <= steps; ++step) {
    Point farthest = centre;
    for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
      const Point point = vertex_of(mesh, i);
      farthest = distance(centre, point) > distance(centre, farthest) ? point : farthest;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      centre[axis] += (farthest[axis] - centre[axis]) / (step + 1);
    }
  }
  double radius = 0;
  for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
    radius = std::fmax(radius, distance(centre, vertex_of(mesh, i)));
  }
  return {centre, radius};
}

}  // namespace flashbvh::tool
