#include "bake/mesh.hpp"

#include <unordered_map>

namespace flashbvh::bake {

namespace {

template <class Mesh>
void add_part(const Mesh& mesh, const std::vector<std::uint32_t>& numbers, Mesh& part) {
  std::unordered_map<std::uint32_t, std::uint32_t> index_of;
  for (const std::uint32_t number : numbers) {
    TriangleCorners corners = mesh.triangles[number];
    for (std::uint32_t& corner : corners) {
      const auto next = static_cast<std::uint32_t>(part.vertices.size());
      const auto [entry, is_new] = index_of.try_emplace(corner, next);
      if (is_new) {
        part.vertices.push_back(mesh.vertices[corner]);
      }
      corner = entry->second;
    }
    part.triangles.push_back(corners);
  }
}

}  // namespace

SourceMesh part_of(const SourceMesh& mesh, const std::vector<std::uint32_t>& numbers) {
  SourceMesh part;
  add_part(mesh, numbers, part);
  return part;
}

LatticeMesh part_of(const LatticeMesh& mesh, const std::vector<std::uint32_t>& numbers) {
  LatticeMesh part = {mesh.cell, mesh.origin, {}, {}, mesh.deviation};
  add_part(mesh, numbers, part);
  return part;
}

SourceMesh source_of(const LatticeMesh& mesh) {
  SourceMesh source;
  for (const Vertex& vertex : mesh.vertices) {
    source.vertices.push_back({(mesh.origin[0] + vertex.x) * mesh.cell,
                               (mesh.origin[1] + vertex.y) * mesh.cell,
                               (mesh.origin[2] + vertex.z) * mesh.cell});
  }
  source.triangles = mesh.triangles;
  return source;
}

void append(const SourceMesh& more, SourceMesh& mesh) {
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const TriangleCorners& corners : more.triangles) {
    mesh.triangles.push_back({corners[0] + base, corners[1] + base, corners[2] + base});
  }
}

}  // namespace flashbvh::bake
