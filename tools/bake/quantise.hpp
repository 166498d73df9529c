// Rounds a mesh in its unit to the lattice.
#pragma once

#include "bake/mesh.hpp"

namespace flashbvh::bake {

/// Where a mesh lies in its frame, by axis, in its unit.
struct Extent {
  std::array<double, 3> low;
  std::array<double, 3> high;

  /// Zeros for a mesh without vertices.
  std::array<double, 3> size() const;
};

/// O(n).
Extent extent_of(const SourceMesh& mesh);

/// A cell with which the mesh fits the lattice, in the mesh's unit: its largest extent over
/// 2 * kMaxCoordinate, and no less than firmware can hold in a float. Rounding enlarges it by one
/// part in 2 * kMaxCoordinate - 1 at most.
double finest_cell(const Extent& extent);

/// True if the mesh fits the lattice with this cell: at most 2 * kMaxCoordinate cells wide, and
/// within 2^29 cells of its frame's origin.
bool fits(const Extent& extent, double cell);

/// The least float that is not below the length; FLT_MAX for a longer one.
float float_above(double length);
/// The length in 1/parts of the cell, rounded up.
double parts_above(double length, double cell, double parts);
/// Mesh::deviation_sixteenths of a deviation.
std::uint16_t sixteenths_above(double deviation, double cell);

/// A tight upper bound of the motion of a vertex by rounding to the lattice, in the mesh's unit. 0
/// if no vertex moves.
double deviation(const SourceMesh& mesh, double cell);

/// Rounds each coordinate to the nearest multiple of `cell`, halves away from zero (also halves
/// that are inexact by rounding), and joins vertices that coincide. The origin is in the middle of
/// `extent`, the mesh's. Precondition: fits(extent, cell).
LatticeMesh round_to_lattice(const SourceMesh& mesh, const Extent& extent, double cell);

}  // namespace flashbvh::bake
