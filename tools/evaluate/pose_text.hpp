// Poses as text: 12 numbers, the rotation row by row, then the translation, B into A's frame.
#ifndef FLASHBVH_TOOLS_EVALUATE_POSE_TEXT_HPP
#define FLASHBVH_TOOLS_EVALUATE_POSE_TEXT_HPP

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace flashbvh::tool {

/// In the mesh's unit.
struct RigidPose {
  std::array<std::array<double, 3>, 3> rotation;  ///< row by row
  std::array<double, 3> translation;
};

/// A pose and where it stands, for messages.
struct PlacedPose {
  RigidPose pose;
  std::string place;  ///< "FILE:LINE"
};

/// UserError, naming `place`, unless `text` is 12 finite numbers.
RigidPose parse_pose(std::string_view text, const std::string& place);

/// One pose a line; '#' starts a comment; empty lines don't count. UserError if there is none.
std::vector<PlacedPose> read_poses(const std::string& path);

}  // namespace flashbvh::tool

#endif
