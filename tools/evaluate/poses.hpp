// Poses: as text, of 12 numbers, the rotation row by row, then the translation, B into A's frame in
// the mesh's unit; on the lattice, as the library takes them; and where they put a mesh. Points and
// rays as text, in a mesh's frame and unit.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "flashbvh/pose.hpp"
#include "flashbvh/ray.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

/// In the mesh's unit.
struct RigidPose {
  std::array<std::array<double, 3>, 3> rotation;  ///< row by row
  std::array<double, 3> translation;
};

/// As firmware has it of a mesh of this cell: cells_per_unit().
float cells_in_unit(double cell);

/// The translation is rounded to 1/65,536 of a cell, the rotation to 2^-30, halves away from zero;
/// what the library makes of them is in Pose::rigid(). UserError, naming `place`, if the matrix is
/// no rotation within kRotationTolerance or translates B beyond kMaxTranslation.
Pose lattice_pose(const RigidPose& pose, double cell, const std::string& place);

/// The pose of 12 finite numbers; UserError if they are others. `as_floats`: by firmware's own
/// pose_of() (flashbvh/float.hpp): the numbers as 32-bit floats, the translation multiplied by
/// the cells in a unit.
Pose read_lattice_pose(std::string_view text, double cell, const std::string& place,
                       bool as_floats);

/// One pose a line; '#' starts a comment; empty lines don't count. UserError if there is none.
std::vector<Pose> read_lattice_poses(const std::string& path, double cell, bool as_floats = false);

/// A pose's 12 numbers, the translation in the unit of the cell.
std::array<double, 12> pose_numbers(const Pose& pose, double cell);

/// The vertices of B in cells of A's frame: where a query has them, whatever the A, and where it
/// would have those that are too far from A for it to look.
std::vector<LatticePoint> transformed_vertices(const AnyTree& b, const Pose& pose);

/// One point a line, to the nearest cells, halves away from zero; '#' starts a comment; empty lines
/// don't count. UserError, naming the line, if there is none, one is no three numbers, or it lies
/// beyond 2^29 cells.
std::vector<Point> read_lattice_points(const std::string& path, double cell);

/// One ray a line, in the same form: two points, from one to the other; or an origin, a direction
/// and a reach, as segment_of() takes them as floats.
std::vector<Segment> read_lattice_rays(const std::string& path, double cell);

}  // namespace flashbvh::tool
