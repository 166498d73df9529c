// Closed boxes, also inside out, also into each other.
#ifndef FLASHBVH_TESTS_SUPPORT_BOXES_HPP
#define FLASHBVH_TESTS_SUPPORT_BOXES_HPP

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

/// Boxes on a few cells, so that corners, edges and faces lie above each other.
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

}  // namespace flashbvh::test

#endif
