// Parts of a robot's image: for open_robot() and the tests.
#ifndef FLASHBVH_DETAIL_ROBOT_IMAGE_PARTS_HPP
#define FLASHBVH_DETAIL_ROBOT_IMAGE_PARTS_HPP

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/robot/image.hpp"

namespace flashbvh::detail {

/// Where the first mesh lies, in bytes from the start of the image.
uint32_t robot_meshes_offset(const RobotImageHeader& header);

/// Whether a robot's arrays keep the rules, all but its meshes, which are not looked at. Its counts
/// are within their bounds and the arrays are there; nothing else needs to be right.
bool check_robot(const Robot& robot, uint32_t& pair_joint_count);

/// Whether the spheres of its links hold their meshes.
bool check_spheres(const Robot& robot);

/// open_robot() but for the hash.
Status open_robot_unhashed(const void* bytes, size_t size, Mesh* meshes, uint32_t mesh_capacity,
                           Robot& robot);

}  // namespace flashbvh::detail

#endif
