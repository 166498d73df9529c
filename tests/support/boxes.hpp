// Closed boxes, which may be inside out or overlap, and the winding number of a closed mesh by
// solid angles, which the library does not use.
#pragma once

#include <cmath>

#include "support/random.hpp"
#include "support/shapes.hpp"

namespace flashbvh::test {

/// A box, or one that is inside out.
inline void add_box(bake::LatticeMesh& mesh, const Point& lower, const Point& size, bool turned) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back({static_cast<std::int16_t>(lower.x + (i & 1) * size.x),
                             static_cast<std::int16_t>(lower.y + (i >> 1 & 1) * size.y),
                             static_cast<std::int16_t>(lower.z + (i >> 2) * size.z)});
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
    const auto at = [&] { return random.between(-4, 4); };
    const auto size = [&] { return random.between(1, 5); };
    const Point lower = {at(), at(), at()};
    const Point extent = {size(), size(), size()};
    add_box(mesh, lower, extent, random.below(4) == 0);
  }
  return mesh;
}

inline double length_of(const double (&v)[3]) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// The solid angle of a triangle, seen from a point off it; positive if its back faces the point.
/// Source: Van Oosterom and Strackee, IEEE Transactions on Biomedical Engineering 30(2), 1983.
inline double solid_angle(const Triangle& t, const Point& p) {
  double v[3][3];
  for (int i = 0; i < 3; ++i) {
    v[i][0] = t.corner[i].x - p.x;
    v[i][1] = t.corner[i].y - p.y;
    v[i][2] = t.corner[i].z - p.z;
  }
  const auto dot = [&](int i, int j) {
    return v[i][0] * v[j][0] + v[i][1] * v[j][1] + v[i][2] * v[j][2];
  };
  const double volume = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
                        v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
                        v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
  const double a = length_of(v[0]);
  const double b = length_of(v[1]);
  const double c = length_of(v[2]);
  return 2 * std::atan2(volume, a * b * c + dot(0, 1) * c + dot(1, 2) * a + dot(2, 0) * b);
}

/// The winding number, from the sum of all triangles' solid angles.
inline long winding_of(double angles) {
  return std::lround(angles / (4 * 3.14159265358979323846));
}

}  // namespace flashbvh::test
