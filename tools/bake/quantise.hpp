// From a mesh in its unit to a mesh on the lattice.
#pragma once

#include "bake/mesh.hpp"

namespace flashbvh::bake {

/// A cell with which `mesh` fits the lattice, in the mesh's unit: its largest extent over
/// 2 * kMaxCoordinate, or as much more as rounding takes, one part in 2 * kMaxCoordinate - 1 at
/// most. A mesh of no extent fits any cell; for it this is the smallest positive normal number.
double finest_cell(const SourceMesh& mesh);

/// Whether `mesh` fits the lattice with this cell: at most 2 * kMaxCoordinate cells wide, and
/// within 2^29 cells of its frame's origin.
bool fits(const SourceMesh& mesh, double cell);

/// The numbers of the triangles that reach past the lattice that lies around the mesh's middle with
/// this cell, ascending; none if the mesh fits.
std::vector<std::uint32_t> out_of_range(const SourceMesh& mesh, double cell);

/// How far rounding to the lattice moves a vertex of the mesh, at most, in the mesh's unit.
double deviation(const SourceMesh& mesh, double cell);

/// Rounds each coordinate to the nearest multiple of `cell`, halves away from zero (and what would
/// be one if numbers were exact), and joins vertices that fall together. Precondition: fits(mesh,
/// cell).
LatticeMesh round_to_lattice(const SourceMesh& mesh, double cell);

}  // namespace flashbvh::bake
