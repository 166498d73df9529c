// The meshes of baking: as read, and on the lattice.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "flashbvh/lattice.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh::bake {

using TriangleCorners = std::array<std::uint32_t, 3>;

/// As read from a file: vertices in the mesh's unit, joined by position.
struct SourceMesh {
  std::vector<std::array<double, 3>> vertices;
  std::vector<TriangleCorners> triangles;
};

void append(const SourceMesh& more, SourceMesh& mesh);

/// A rounded mesh: vertex i lies at (origin + vertices[i]) * cell.
struct LatticeMesh {
  double cell = 1;                         ///< in the mesh's unit
  std::array<std::int32_t, 3> origin{};    ///< in cells
  std::vector<Vertex> vertices;            ///< joined by position
  std::vector<TriangleCorners> triangles;  ///< in the source's order
  double deviation = 0;  ///< largest distance of a point from its source, in the mesh's unit
};

/// The mesh in its unit and frame.
SourceMesh source_of(const LatticeMesh& mesh);

/// A mesh of the triangles with these numbers and their vertices, in order of first use.
SourceMesh part_of(const SourceMesh& mesh, const std::vector<std::uint32_t>& numbers);
LatticeMesh part_of(const LatticeMesh& mesh, const std::vector<std::uint32_t>& numbers);

}  // namespace flashbvh::bake
