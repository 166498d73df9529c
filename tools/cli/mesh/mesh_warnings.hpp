// What is said of a mesh that was baked.
#ifndef FLASHBVH_TOOLS_CLI_MESH_WARNINGS_HPP
#define FLASHBVH_TOOLS_CLI_MESH_WARNINGS_HPP

#include "image/baking.hpp"

namespace flashbvh::tool {

/// A line for each kind of defect, and one if the mesh is known less exactly than the lattice of
/// `options.cell` can represent.
void warn_of_mesh(const InputMesh& mesh, const MeshDefects& defects, const BakeOptions& options,
                  Warnings& warnings);

/// If the mesh is known less exactly than the lattice of `cell` can represent.
void warn_of_precision(const InputMesh& mesh, double cell, Warnings& warnings);

/// Of a surface that is not closed, or not oriented, or inside out. `path`: the mesh or image.
void warn_of_surface(const MeshDefects& defects, const std::string& path, Warnings& warnings);

/// If the mesh lies so far from its frame's origin that rotations place it less exactly by more
/// than 1/32 cell. `origin`: of its lattice, in cells.
void warn_of_place(const std::array<std::int32_t, 3>& origin, const std::string& path,
                   Warnings& warnings);

}  // namespace flashbvh::tool

#endif
