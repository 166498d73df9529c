#include "bake/surface.hpp"

#include <algorithm>
#include <map>

#include "bake/length.hpp"

namespace flashbvh::bake {
namespace {

std::uint64_t squared_length(const Vertex& p, const Vertex& q) {
  const auto square = [](std::int64_t difference) {
    return static_cast<std::uint64_t>(difference * difference);
  };
  return square(p.x - q.x) + square(p.y - q.y) + square(p.z - q.z);
}

}  // namespace

bool is_closed(const std::vector<TriangleCorners>& triangles) {
  std::map<std::array<std::uint32_t, 2>, std::int64_t> runs;  // forward less backward, by edge
  for (const TriangleCorners& corners : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t u = corners[i];
      const std::uint32_t v = corners[(i + 1) % 3];
      runs[{std::min(u, v), std::max(u, v)}] += u < v ? 1 : v < u ? -1 : 0;
    }
  }
  return std::all_of(runs.begin(), runs.end(), [](const auto& edge) { return edge.second == 0; });
}

std::vector<std::uint32_t> shells_of(const std::vector<TriangleCorners>& triangles,
                                     std::size_t vertex_count) {
  Shells shells(vertex_count);
  for (const TriangleCorners& corners : triangles) {
    shells.join(corners[0], corners[1]);
    shells.join(corners[1], corners[2]);
  }
  std::vector<std::uint32_t> first(vertex_count);
  for (std::uint32_t i = 0; i < vertex_count; ++i) {
    first[i] = shells.first_of(i);
  }
  return first;
}

Surface surface_of(const LatticeMesh& mesh) {
  std::uint64_t longest = 0;
  for (const TriangleCorners& corners : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      longest = std::max(
          longest, squared_length(mesh.vertices[corners[i]], mesh.vertices[corners[(i + 1) % 3]]));
    }
  }
  const std::vector<std::uint32_t> first = shells_of(mesh.triangles, mesh.vertices.size());
  Surface surface;
  const std::uint64_t root = square_root(longest);  // rounded down
  surface.longest_edge = static_cast<std::uint16_t>(root * root < longest ? root + 1 : root);
  surface.is_closed = is_closed(mesh.triangles);
  for (const TriangleCorners& corners : mesh.triangles) {
    surface.shell_vertices.push_back(first[corners[0]]);
  }
  std::sort(surface.shell_vertices.begin(), surface.shell_vertices.end());
  surface.shell_vertices.erase(
      std::unique(surface.shell_vertices.begin(), surface.shell_vertices.end()),
      surface.shell_vertices.end());
  return surface;
}

}  // namespace flashbvh::bake
