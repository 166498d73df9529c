// From a pose in the mesh's unit to one on the lattice, as the library takes it; and where that
// puts a mesh.
#ifndef FLASHBVH_TOOLS_EVALUATE_LATTICE_POSE_HPP
#define FLASHBVH_TOOLS_EVALUATE_LATTICE_POSE_HPP

#include <string>
#include <vector>

#include "evaluate/pose_text.hpp"
#include "flashbvh/pose.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

/// The translation is rounded to 1/65,536 of a cell, the rotation to 2^-30, halves away from zero;
/// what the library makes of them is in Pose::rigid(). UserError, naming `place`, if the matrix is
/// no rotation within kRotationTolerance or moves B beyond kMaxTranslation.
Pose lattice_pose(const RigidPose& pose, double cell, const std::string& place);

/// The vertices of B in cells of A's frame: where a query has them, whatever the A, and where it
/// would have those that are too far from A for it to look.
std::vector<LatticePoint> placed_vertices(const AnyTree& b, const Pose& pose);

}  // namespace flashbvh::tool

#endif
