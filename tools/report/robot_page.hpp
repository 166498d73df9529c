// A page about a robot: what `flashbvh robot --report` writes.
#pragma once

#include <string>
#include <vector>

#include "report/page.hpp"
#include "report/simplified_section.hpp"
#include "robot/baked/bake_links.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "robot/matrix/matrix.hpp"
#include "robot/matrix/unguarded.hpp"

namespace flashbvh::tool {

/// A robot that was baked, its pairs decided; all outlives the page's making.
struct DecidedRobot {
  const Model& model;
  const std::vector<WholeMesh>& wholes;  ///< of the links, and of their parts
  const std::vector<BakedLink>& links;   ///< of the same ones
  const FixedRobot& fixed;
  const std::vector<JointZone>& zones;
  const std::vector<PairVerdict>& pairs;  ///< (0, 1), (0, 2), ...
  std::string stop;                       ///< metres, as they were given
  std::string warn;
  const std::vector<UnguardedPair>& unguarded;
  const std::vector<std::uint32_t>& image;
  const CoarseMeshes& simplified;  ///< none: links are as the URDF has them

  const Robot& robot() const { return fixed.robot(); }
};

/// One self-contained HTML file, the same bytes for the same robot: what firmware holds, what can
/// collide and why, how rare that is and how it looks. `step`: shares of two.
std::string robot_page(const DecidedRobot& decided, const OnStep& step);

}  // namespace flashbvh::tool
