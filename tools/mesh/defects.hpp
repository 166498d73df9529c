// Defects of a mesh: no query fails by them, but users often did not intend them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::tool {

/// Numbers of triangles, ascending.
using TriangleIds = std::vector<std::uint32_t>;

/// Triangles without area: their corners coincide or lie on a line. Decided exactly, on differences
/// of coordinates rounded to doubles; those of a lattice are exact.
template <class Mesh>
TriangleIds degenerate_triangles(const Mesh& mesh);

/// Triangles that have the three vertices of an earlier one, in any order. O(n log n).
TriangleIds duplicate_triangles(const std::vector<bake::TriangleCorners>& triangles);

/// Edges that the surface of a solid does not have.
struct EdgeDefects {
  std::size_t boundary = 0;      ///< with one triangle
  std::size_t non_manifold = 0;  ///< with more than two
  std::size_t twisted = 0;       ///< with two triangles that face opposite ways

  bool none() const { return boundary == 0 && non_manifold == 0 && twisted == 0; }
};

enum class EdgeDefect : std::uint8_t { boundary, non_manifold, twisted };

/// An edge by its vertices, and its defect.
struct OddEdge {
  std::array<std::uint32_t, 2> vertices;
  EdgeDefect defect;
};

/// The edges with defects. Duplicate triangles count once, and triangles with coinciding corners
/// not at all. O(n log n).
std::vector<OddEdge> odd_edges(const std::vector<bake::TriangleCorners>& triangles,
                               const TriangleIds& duplicates);
/// The number of these edges by defect.
EdgeDefects edge_defects(const std::vector<bake::TriangleCorners>& triangles,
                         const TriangleIds& duplicates);

/// Defects of a mesh after rounding to the lattice, and before it.
struct MeshDefects {
  TriangleIds degenerate;             ///< without area in the file
  TriangleIds collapsed;              ///< without area by rounding alone
  TriangleIds duplicates;             ///< on the lattice
  EdgeDefects edges;                  ///< on the lattice
  bool closed_before = false;         ///< edges have defects by rounding alone
  bool inside_out = false;            ///< closed, oriented, and normals face into the solid
  std::size_t shells_inside_out = 0;  ///< of them, in a mesh of several
};

/// The defects that a mesh on the lattice has by itself.
MeshDefects surface_defects(const bake::LatticeMesh& mesh);
/// `degenerate`: of the mesh in the file.
MeshDefects defects_of(const bake::SourceMesh& mesh, const bake::LatticeMesh& rounded,
                       const TriangleIds& degenerate);

/// Sets what is inside out: the surface, if it encloses a negative volume; shells, parts that share
/// no vertex, that do so and are no cavities: not within the others, at up to some thousand points.
/// Precondition: no edge has a defect. The volume is exact while no cell is within over 2^15
/// shells.
void set_orientation(const bake::LatticeMesh& mesh, MeshDefects& defects);

}  // namespace flashbvh::tool
