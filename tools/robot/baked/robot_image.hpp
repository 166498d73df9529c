// A robot as a binary image (flashbvh/robot/image.hpp, lib/docs/format.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/baked/fixed_robot.hpp"
#include "robot/matrix/unguarded.hpp"

namespace flashbvh::tool {

/// UserError if an image holds fewer links, or fewer bytes of names, or if the robot has limits
/// that exclude all values.
void check_image(const Model& model, const std::string& name, double cell);

/// The image in words, so that it is aligned. `meshes`: the links' images, post-indexed, with
/// 16-bit indices, in metres. Names are cut after 255 bytes. UserError as check_image(), or if it
/// would be 4 GiB or more.
std::vector<std::uint32_t> robot_image(const Model& model, const Robot& robot,
                                       const std::vector<UnguardedPair>& unguarded,
                                       const std::vector<std::vector<std::uint32_t>>& meshes,
                                       const std::string& name);

/// The number of joints between two links, summed over all pairs.
std::uint32_t pair_joint_count(const Robot& robot);

/// The size of the image without its meshes.
std::size_t own_image_bytes(const Model& model, const Robot& robot,
                            const std::vector<UnguardedPair>& unguarded, const std::string& name);

}  // namespace flashbvh::tool
