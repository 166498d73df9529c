// A robot's image as source: NAME.robot.h and NAME.robot.c, both C99 and C++.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/c_writer.hpp"
#include "robot/matrix/unguarded.hpp"

namespace flashbvh::tool {

/// The state of a guard of the robot: plain data, equally large on every core.
std::size_t robot_ram_bytes(const Robot& robot);

/// `NAME_robot_image`, and constants, whose names begin with NAME_.
SourceFiles robot_in_c(const std::vector<std::uint32_t>& image, const Model& model,
                       const Robot& robot, const std::vector<UnguardedPair>& unguarded,
                       const OutputName& name);

}  // namespace flashbvh::tool
