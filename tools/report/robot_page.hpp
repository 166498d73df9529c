// The page about a robot that `flashbvh robot --report` writes.
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

/// A baked robot with its pairs decided; all references must stay valid while the page is made.
struct DecidedRobot {
  const Model& model;
  const std::vector<WholeMesh>& wholes;  ///< of the links, and of their parts
  const std::vector<BakedLink>& links;   ///< of these links and parts
  const FixedRobot& fixed;
  const std::vector<JointZone>& zones;
  const std::vector<PairVerdict>& pairs;  ///< (0, 1), (0, 2), ...
  std::string stop;                       ///< metres, as given
  std::string warn;
  const std::vector<UnguardedPair>& unguarded;
  const std::vector<std::uint32_t>& image;
  const CoarseMeshes& simplified;  ///< empty: links have all triangles of the URDF's meshes

  const Robot& robot() const { return fixed.robot(); }
};

/// One self-contained HTML file, the same bytes for the same robot: the contents of firmware, the
/// pairs that can collide, with reasons and frequencies, the robot to move. `step`: shares of two.
std::string robot_page(const DecidedRobot& decided, const OnStep& step);

}  // namespace flashbvh::tool
