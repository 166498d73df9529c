// What is said of a mesh that was baked.
#ifndef FLASHBVH_TOOLS_CLI_MESH_WARNINGS_HPP
#define FLASHBVH_TOOLS_CLI_MESH_WARNINGS_HPP

#include "image/baking.hpp"

namespace flashbvh::tool {

/// A line for each kind of defect, and one if the mesh is known less exactly than the lattice of
/// `options.cell` can tell.
void warn_of_mesh(const InputMesh& mesh, const MeshDefects& defects, const BakeOptions& options,
                  Warnings& warnings);

}  // namespace flashbvh::tool

#endif
