// From a pose in the mesh's unit to one on the lattice, as the library takes it.
#ifndef FLASHBVH_TOOLS_LATTICE_POSE_HPP
#define FLASHBVH_TOOLS_LATTICE_POSE_HPP

#include <string>

#include "flashbvh/pose.hpp"
#include "flashbvh/pose_text.hpp"

namespace flashbvh::tool {

/// The translation in cells is rounded, halves away from zero. UserError, naming `place`, if the
/// pose turns B or moves it beyond kMaxTranslation.
Pose lattice_pose(const RigidPose& pose, double cell, const std::string& place);

/// A point of B, in cells of B's frame, in cells of A's frame: where the query has it.
std::array<std::int64_t, 3> placed(const std::array<std::int64_t, 3>& point, const Pose& pose);

}  // namespace flashbvh::tool

#endif
