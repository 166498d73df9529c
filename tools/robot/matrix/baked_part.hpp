// Meshes baked for a proof: kept in memory, never written.
#pragma once

#include <array>
#include <vector>

#include "bake/baked_tree.hpp"
#include "bake/mesh.hpp"
#include "mesh/import.hpp"

namespace flashbvh::tool {

/// Pairs are decided on the meshes as read, with any number of triangles. Firmware gets other trees
/// (robot/baked/bake_links.hpp).
using WholeMesh = Mesh32;
using BakedPart = bake::BakedTree<WholeMesh::Index, Layout::post_indexed>;

/// A vertex, in cells of the mesh's frame.
template <class MeshType>
std::array<double, 3> vertex_of(const MeshType& mesh, std::uint32_t number) {
  const Vertex& vertex = mesh.vertices[number];
  return {1.0 * mesh.origin[0] + vertex.x, 1.0 * mesh.origin[1] + vertex.y,
          1.0 * mesh.origin[2] + vertex.z};
}
template <class MeshType>
std::vector<std::array<double, 3>> vertices_of(const MeshType& mesh) {
  std::vector<std::array<double, 3>> vertices;
  for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
    vertices.push_back(vertex_of(mesh, i));
  }
  return vertices;
}

/// Bakes a mesh of at least one triangle, in metres. UserError if it does not fit the lattice.
/// `leaf_size`: most triangles in a leaf.
BakedPart bake_part(const InputMesh& mesh, double cell, std::uint32_t leaf_size);
BakedPart bake_part(const bake::SourceMesh& mesh, double cell);

/// Views of the parts.
std::vector<WholeMesh> views_of(const std::vector<BakedPart>& parts);

}  // namespace flashbvh::tool
