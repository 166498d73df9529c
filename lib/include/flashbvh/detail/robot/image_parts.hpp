// Parts of a robot's image: for open_robot() and the tests.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/robot/image.hpp"

namespace flashbvh::detail {

/// The first mesh's place, in bytes from the start of the image.
uint32_t robot_meshes_offset(const RobotImageHeader& header);

/// True if a robot's arrays are valid; its meshes are not checked. The counts must be within their
/// bounds and the arrays must exist; nothing else needs to be right.
bool check_robot(const Robot& robot, uint32_t& pair_joint_count);

/// True if the spheres of the robot's links contain their meshes.
bool check_spheres(const Robot& robot);

/// open_robot() without the test of the hash.
Status open_robot_unhashed(const void* bytes, size_t size, Mesh* meshes, uint32_t mesh_capacity,
                           Robot& robot);

}  // namespace flashbvh::detail
