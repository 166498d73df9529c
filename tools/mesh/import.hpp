// Reads mesh files of all formats, distinguished by their extensions.
#pragma once

#include <string>
#include <vector>

#include "bake/quantise.hpp"
#include "mesh/defects.hpp"
#include "mesh/mesh_builder.hpp"
#include "mesh/units.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// The formats that are read, for messages.
extern const char* const kMeshFormats;

/// Reads a mesh file. Keeps all triangles in the file's order, also those without area and repeated
/// ones. Cuts polygons into triangles in place. Joins equal vertices, in order of first use. Omits
/// points and lines with a warning; PLY refuses polygons of fewer than three corners.
/// UserError if the file is missing, empty, truncated, not a mesh, without triangles, or has a
/// coordinate that is not finite.
FileMesh import_mesh(const std::string& path, Warnings& warnings);

/// A mesh to bake.
struct InputMesh {
  std::string path;
  bake::SourceMesh mesh;   ///< converted to the common unit
  bake::Extent extent;     ///< of the mesh
  double finest_cell;      ///< with which it fits the lattice
  TriangleIds degenerate;  ///< before conversion
  double precision = 0;    ///< bound on the reader's rounding of a coordinate, in the common unit
  Unit unit = Unit::none;  ///< that the file carries

  /// A bound on the distance of a vertex from the file's, by the reader's rounding.
  double reading_error() const;
};

/// `path`: for messages. `degenerate`: triangles without area that are not due to rounding.
InputMesh input_of(std::string path, bake::SourceMesh mesh, TriangleIds degenerate = {},
                   double precision = 0);

/// Reads a mesh with import_mesh() and converts it to the common unit.
InputMesh read_mesh(const std::string& path, const Units& units, Warnings& warnings);

/// For meshes read without a common unit. UserError if their files carry several units; warns if
/// some carry one and others none.
void check_units(const std::vector<InputMesh>& meshes, Warnings& warnings);

}  // namespace flashbvh::tool
