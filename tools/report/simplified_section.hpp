// The section on simplified meshes: source and baked mesh together, the point of largest deviation,
// and the sizes for other deviations.
#pragma once

#include <string>
#include <vector>

#include "bake/mesh.hpp"
#include "report/html.hpp"
#include "simplify/fit.hpp"

namespace flashbvh::tool {

/// A source mesh and its baked mesh.
struct CoarseMesh {
  std::string name;
  const bake::SourceMesh& original;
  bake::SourceMesh coarse;
  double deviation;  ///< the largest, in both directions
};

struct CoarseMeshes {
  std::vector<CoarseMesh> meshes;
  std::vector<simplify::LengthRow> lengths;
  std::vector<std::uint32_t> leaf_sizes;  ///< of the rows' columns
  Measure measure{1, ""};
};

/// Lengths and coordinates are in the meshes' unit.
std::string simplified_section(const CoarseMeshes& all);
/// The page of `flashbvh bake --report`.
std::string simplified_page(const CoarseMeshes& all);

/// The mesh of a baked tree, in the unit of its cell.
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
