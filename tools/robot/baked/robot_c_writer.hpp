// A robot as C99: constants and declarations in a header, constant arrays in a source file.
#ifndef FLASHBVH_TOOLS_ROBOT_BAKED_ROBOT_C_WRITER_HPP
#define FLASHBVH_TOOLS_ROBOT_BAKED_ROBOT_C_WRITER_HPP

#include <vector>

#include "image/source_text.hpp"
#include "robot/baked/bake_links.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "robot/matrix/unguarded.hpp"

namespace flashbvh::tool {

/// NAME.robot.h and NAME.robot.c: `NAME_robot` for flashbvh/robot.h, and its constants, whose names
/// begin with NAME_. Meshes lie in their images, which need no opening.
SourceFiles robot_in_c(const Model& model, const FixedRobot& robot,
                       const std::vector<BakedLink>& links,
                       const std::vector<UnguardedPair>& unguarded, const OutputName& name);

}  // namespace flashbvh::tool

#endif
