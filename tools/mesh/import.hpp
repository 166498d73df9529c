// Mesh files of all formats, distinguished by their extensions.
#pragma once

#include <string>
#include <vector>

#include "bake/mesh.hpp"
#include "mesh/defects.hpp"
#include "mesh/mesh_builder.hpp"
#include "mesh/units.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// The formats that are read, for messages.
extern const char* const kMeshFormats;

/// Whether the extension is that of a format of meshes or of robots, be it one that is read or not.
bool is_mesh_name(const std::string& path);

/// Reads a mesh file: its triangles in the file's order, none left out (not those without area, nor
/// repeated ones), polygons cut into triangles in place; vertices joined where they are equal, in
/// order of first use. Points and lines are left out with a warning. UserError if the file is
/// missing, empty, truncated, not a mesh, without triangles, or has a coordinate that is not
/// finite.
FileMesh import_mesh(const std::string& path, Warnings& warnings);

/// A mesh to bake.
struct InputMesh {
  std::string path;                 ///< with the body if it is one of the file's
  std::vector<std::string> bodies;  ///< their names in the file
  bake::SourceMesh mesh;            ///< converted to the common unit
  TriangleIds degenerate;           ///< before it was converted
  double precision = 0;  ///< how far the reader may have rounded a coordinate, in the common unit
};

/// import_mesh(), in the common unit.
InputMesh read_mesh(const std::string& path, const Units& units, Warnings& warnings);
/// The same, each body a mesh of its own, in order of their first triangles.
std::vector<InputMesh> read_bodies(const std::string& path, const Units& units, Warnings& warnings);

}  // namespace flashbvh::tool
