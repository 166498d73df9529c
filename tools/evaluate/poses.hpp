// Poses: as text, of 12 numbers, the rotation row by row, then the translation, B into A's frame in
// the mesh's unit; on the lattice, as the library takes them; and where they put a mesh.
#ifndef FLASHBVH_TOOLS_EVALUATE_POSES_HPP
#define FLASHBVH_TOOLS_EVALUATE_POSES_HPP

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "flashbvh/pose.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

/// In the mesh's unit.
struct RigidPose {
  std::array<std::array<double, 3>, 3> rotation;  ///< row by row
  std::array<double, 3> translation;
};

/// A pose and where it stands, for messages.
struct PoseAtLine {
  RigidPose pose;
  std::string place;  ///< "FILE:LINE"
};

/// UserError, naming `place`, unless `text` is 12 finite numbers.
RigidPose parse_pose(std::string_view text, const std::string& place);

/// One pose a line; '#' starts a comment; empty lines don't count. UserError if there is none.
std::vector<PoseAtLine> read_poses(const std::string& path);

/// The translation is rounded to 1/65,536 of a cell, the rotation to 2^-30, halves away from zero;
/// what the library makes of them is in Pose::rigid(). UserError, naming `place`, if the matrix is
/// no rotation within kRotationTolerance or translates B beyond kMaxTranslation.
Pose lattice_pose(const RigidPose& pose, double cell, const std::string& place);

/// The same by firmware's own pose_of() (flashbvh/float.hpp): the numbers as 32-bit floats,
/// the translation multiplied by the cells in a unit.
Pose pose_of_floats(const RigidPose& pose, double cell, const std::string& place);

/// All poses of a file. UserError as read_poses() and lattice_pose().
std::vector<Pose> read_lattice_poses(const std::string& path, double cell, bool as_floats = false);

/// The vertices of B in cells of A's frame: where a query has them, whatever the A, and where it
/// would have those that are too far from A for it to look.
std::vector<LatticePoint> transformed_vertices(const AnyTree& b, const Pose& pose);

}  // namespace flashbvh::tool

#endif
