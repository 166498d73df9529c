// Poses as text of 12 numbers: the rotation row by row, then the translation, of B in A's frame in
// the mesh's unit. Poses on the lattice, as in the library. Points and rays as text, in a mesh's
// frame and unit.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "flashbvh/pose.hpp"
#include "flashbvh/ray.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

/// Maps point p to rotation * p + translation.
struct Transform {
  std::array<std::array<double, 3>, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< by rows
  std::array<double, 3> translation{};
};

/// Rounds the translation to 1/65,536 of a cell and the rotation to 2^-30, halves away from zero;
/// Pose::rigid() documents the result. UserError, naming `place`, if the matrix is no rotation
/// within kRotationTolerance or translates B beyond kMaxTranslation.
Pose lattice_pose(const Transform& pose, double cell, const std::string& place);

/// The pose of 12 finite numbers; else UserError.
Pose read_lattice_pose(std::string_view text, double cell, const std::string& place);

/// Reads one pose per line; '#' starts a comment; empty lines don't count. UserError without poses.
std::vector<Pose> read_lattice_poses(const std::string& path, double cell);

/// A pose's 12 numbers, the translation in the unit of the cell.
std::array<double, 12> pose_numbers(const Pose& pose, double cell);

/// Reads one point per line, rounded to the nearest cells, halves away from zero; '#' starts a
/// comment; empty lines are skipped. UserError, naming the line, if there is none, a line is not
/// three numbers, or a point lies beyond 2^29 cells.
std::vector<Point> read_lattice_points(const std::string& path, double cell);

/// Reads one ray per line, in the same form: two points, its start and its end.
std::vector<Segment> read_lattice_rays(const std::string& path, double cell);

}  // namespace flashbvh::tool
