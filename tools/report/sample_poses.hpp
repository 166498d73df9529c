// Random poses, the same on every machine.
#ifndef FLASHBVH_TOOLS_REPORT_SAMPLE_POSES_HPP
#define FLASHBVH_TOOLS_REPORT_SAMPLE_POSES_HPP

#include <cstdint>
#include <vector>

#include "flashbvh/image_file.hpp"
#include "flashbvh/pose.hpp"

namespace flashbvh::report {

/// B turned by any rotation, each as likely as the other, and moved so that the middle of its box
/// lies in any direction from the middle of A's, at any distance from 0 to the sum of half their
/// boxes' diagonals: from there on their boxes are apart however they are turned. Always the same
/// poses for the same trees. Some may not be `done`: where a mesh lies too far from its origin.
std::vector<Pose> sample_poses(const tool::AnyTree& a, const tool::AnyTree& b, std::size_t count);

}  // namespace flashbvh::report

#endif
