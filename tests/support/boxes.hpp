// Closed boxes, which may be inside out or overlap, and the winding number of a closed mesh by
// solid angles, which the library does not use.
#pragma once

#include <cmath>

#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/predicates/triangle.hpp"
#include "support/points.hpp"
#include "support/shapes.hpp"
#include "support/vectors.hpp"

namespace flashbvh::test {

/// A box, or one that is inside out.
inline void add_box(bake::LatticeMesh& mesh, const Point& lower, const Point& size, bool turned) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back(vertex_of({lower.x + (i & 1) * size.x, lower.y + (i >> 1 & 1) * size.y,
                                       lower.z + (i >> 2) * size.z}));
  }
  const std::uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& quad : quads) {
    const std::uint32_t second = turned ? 3 : 1;
    const std::uint32_t last = turned ? 1 : 3;
    mesh.triangles.push_back({first + quad[0], first + quad[second], first + quad[2]});
    mesh.triangles.push_back({first + quad[0], first + quad[2], first + quad[last]});
  }
}

/// Boxes on a few cells, so that corners, edges and faces lie above one another.
inline bake::LatticeMesh boxes(Random& random) {
  bake::LatticeMesh mesh;
  const std::uint32_t count = 1 + random.below(3);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Point lower = any_point(random, 4);
    const auto size = [&] { return random.between(1, 5); };
    const Point extent = {size(), size(), size()};
    add_box(mesh, lower, extent, random.below(4) == 0);
  }
  return mesh;
}

/// The solid angle of a triangle, seen from a point off it; positive if its back faces the point.
/// Source: Van Oosterom and Strackee, IEEE Transactions on Biomedical Engineering 30(2), 1983.
inline double solid_angle(const Triangle& t, const Point& p) {
  const auto seen = [&](const Point& corner) {
    return minus(vector_of<double>(corner), vector_of<double>(p));
  };
  const FloatVector u = seen(t.corner[0]);
  const FloatVector v = seen(t.corner[1]);
  const FloatVector w = seen(t.corner[2]);
  const double a = length_of(u);
  const double b = length_of(v);
  const double c = length_of(w);
  return 2 *
         std::atan2(dot(u, cross(v, w)), a * b * c + dot(u, v) * c + dot(v, w) * a + dot(w, u) * b);
}

/// A point's place, from the solid angles of all triangles.
struct Winding {
  bool on_surface;
  long number;  ///< 0 on the surface
};

/// `transform`: if not null, it places the mesh as B.
inline Winding winding_about(const Mesh& mesh, const Point& p,
                             const detail::Transform* transform = nullptr) {
  double angles = 0;
  for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
    Triangle t;
    if (transform == nullptr) {
      detail::translate_triangle(mesh, i, detail::kNoOffset, t);
    } else {
      detail::transform_triangle(mesh, i, *transform, t);
    }
    if (detail::triangles_intersect(t, {{p, p, p}})) {
      return {true, 0};
    }
    angles += solid_angle(t, p);
  }
  return {false, std::lround(angles / (4 * 3.14159265358979323846))};
}

}  // namespace flashbvh::test
