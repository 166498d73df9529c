// A robot as C++: constants and declarations in a header, constant arrays in a source file.
#ifndef FLASHBVH_TOOLS_ROBOT_BAKED_ROBOT_WRITER_HPP
#define FLASHBVH_TOOLS_ROBOT_BAKED_ROBOT_WRITER_HPP

#include <cstddef>
#include <vector>

#include "image/source_text.hpp"
#include "robot/baked/bake_links.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "robot/matrix/unguarded.hpp"

namespace flashbvh::tool {

/// All but the meshes, in bytes, on a 32-bit core.
std::size_t robot_array_bytes(const FixedRobot& robot);

/// What firmware links that uses all of the robot, in bytes, on a 32-bit core.
std::size_t robot_flash_bytes(const FixedRobot& robot, const std::vector<BakedLink>& links);

/// The state of a guard of it: plain data, of the same size on every core. `pair_joint_count`:
/// joints between the links of all pairs.
std::size_t robot_ram_bytes(const Robot& robot, std::size_t pair_joint_count);

/// NAME.robot.hpp and NAME.robot.cpp: `NAME::robot` and its constants.
SourceFiles robot_sources(const Model& model, const FixedRobot& robot,
                          const std::vector<BakedLink>& links,
                          const std::vector<UnguardedPair>& unguarded, const OutputName& name);

}  // namespace flashbvh::tool

#endif
