// What is odd about a mesh: nothing that a query minds, but often not what the user meant.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::tool {

/// Numbers of triangles, ascending.
using TriangleIds = std::vector<std::uint32_t>;

/// Triangles without area, detected by the coordinates as they are: corners that fall together or
/// lie on a line.
TriangleIds degenerate_triangles(const bake::SourceMesh& mesh);
TriangleIds degenerate_triangles(const bake::LatticeMesh& mesh);

/// Triangles that have the three vertices of an earlier one, in any order. O(n log n).
TriangleIds duplicate_triangles(const std::vector<bake::TriangleCorners>& triangles);

/// Edges that the surface of a solid does not have.
struct EdgeDefects {
  std::size_t boundary = 0;      ///< of one triangle
  std::size_t non_manifold = 0;  ///< of more than two
  std::size_t twisted = 0;       ///< of two triangles that face opposite ways

  bool none() const { return boundary == 0 && non_manifold == 0 && twisted == 0; }
};

enum class EdgeDefect : std::uint8_t { boundary, non_manifold, twisted };

/// An edge by its vertices, and what is odd about it.
struct OddEdge {
  std::array<std::uint32_t, 2> vertices;
  EdgeDefect defect;
};

/// Of the distinct triangles: duplicates count once, and those whose corners fall together not at
/// all. O(n log n).
std::vector<OddEdge> odd_edges(const std::vector<bake::TriangleCorners>& triangles,
                               const TriangleIds& duplicates);
/// How many they are.
EdgeDefects edge_defects(const std::vector<bake::TriangleCorners>& triangles,
                         const TriangleIds& duplicates);

/// Whether the surface encloses a negative volume: its triangles run clockwise, seen from outside.
/// Precondition: it is closed and oriented. O(n).
bool is_inside_out(const bake::LatticeMesh& mesh, const TriangleIds& duplicates);

/// What rounding a mesh to the lattice leaves, and what was odd about it before.
struct MeshDefects {
  TriangleIds degenerate;      ///< without area in the file already
  TriangleIds collapsed;       ///< these lose theirs by rounding
  TriangleIds duplicates;      ///< on the lattice
  EdgeDefects edges;           ///< on the lattice
  bool closed_before = false;  ///< whether rounding alone is to blame for the edges
  bool inside_out = false;     ///< closed, oriented, and normals face into the solid
};

/// `degenerate`: of the mesh as it is in the file.
MeshDefects defects_of(const bake::SourceMesh& mesh, const bake::LatticeMesh& rounded,
                       const TriangleIds& degenerate);

}  // namespace flashbvh::tool
