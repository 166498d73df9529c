// What simplifying made of meshes: both on each other, where they are farthest apart, and what each
// length would cost.
#pragma once

#include <string>
#include <vector>

#include "bake/mesh.hpp"
#include "report/html.hpp"
#include "simplify/fit.hpp"

namespace flashbvh::tool {

/// A mesh, and what was baked of it.
struct CoarseMesh {
  std::string name;
  const bake::SourceMesh& original;
  bake::SourceMesh coarse;
  double deviation;  ///< of either from the other, at most
};

struct CoarseMeshes {
  std::vector<CoarseMesh> meshes;
  std::vector<simplify::LengthRow> lengths;
  std::vector<std::uint32_t> leaf_sizes;  ///< of the rows
  Measure measure{1, ""};
};

/// Lengths and coordinates are in the meshes' unit.
std::string simplified_section(const CoarseMeshes& all);
/// The page of `flashbvh bake --report`.
std::string simplified_page(const CoarseMeshes& all);

/// Of a baked tree, in the unit of its cell.
template <class Tree>
bake::SourceMesh mesh_of_tree(const Tree& tree) {
  bake::SourceMesh mesh;
  for (const Vertex& vertex : tree.vertices) {
    mesh.vertices.push_back({(tree.origin[0] + vertex.x) * tree.cell,
                             (tree.origin[1] + vertex.y) * tree.cell,
                             (tree.origin[2] + vertex.z) * tree.cell});
  }
  for (const auto& corners : tree.triangles) {
    mesh.triangles.push_back({corners.corner[0], corners.corner[1], corners.corner[2]});
  }
  return mesh;
}

}  // namespace flashbvh::tool
