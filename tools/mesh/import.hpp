// Mesh files: STL, OBJ, PLY and OFF, through assimp.
#ifndef FLASHBVH_TOOLS_MESH_IMPORT_HPP
#define FLASHBVH_TOOLS_MESH_IMPORT_HPP

#include <string>

#include "bake/mesh.hpp"
#include "mesh/defects.hpp"
#include "mesh/units.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Reads a mesh file: its triangles in the file's order, none left out (not those without area, nor
/// repeated ones), polygons cut into triangles in place; vertices joined where they are equal, in
/// order of first use. Coordinates are 32-bit floats, as assimp reads them.
/// Points and lines are left out with a warning. UserError if the file is missing,
/// empty, truncated, not a mesh, without triangles, or has a coordinate that is not finite.
bake::SourceMesh import_mesh(const std::string& path, Warnings& warnings);

/// A mesh as its file has it.
struct InputMesh {
  std::string path;
  bake::SourceMesh mesh;   ///< converted to the common unit
  TriangleIds degenerate;  ///< before it was converted
};

/// import_mesh(), in the common unit.
InputMesh read_mesh(const std::string& path, const Units& units, Warnings& warnings);

}  // namespace flashbvh::tool

#endif
