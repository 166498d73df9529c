// From joints as a URDF has them to those of a Model: fixed ones folded, axes turned to z, mimics
// named by the variable that moves them.
#ifndef FLASHBVH_TOOLS_ROBOT_READ_KINEMATIC_TREE_HPP
#define FLASHBVH_TOOLS_ROBOT_READ_KINEMATIC_TREE_HPP

#include <string>
#include <vector>

#include "robot/model.hpp"
#include "robot/read/urdf_document.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

struct KinematicTree {
  /// Where a link lies: in the frame of the moving joint that it hangs on, or of the base.
  struct Place {
    std::size_t joint = kNoJoint;
    Transform transform;
  };

  std::vector<ModelJoint> joints;      ///< parents before children, each branch in one run
  std::vector<std::size_t> variables;  ///< as in Model
  std::vector<Place> links;            ///< of each link of the URDF
};

/// `path`: for messages. UserError, naming the joint and the remedy, for axes of no length, limits
/// out of order or of four turns or more, and mimics of nothing, of each other, or that could
/// not turn on where their joint does.
KinematicTree kinematic_tree(const UrdfRobot& robot, const std::string& path, Warnings& warnings);

}  // namespace flashbvh::tool

#endif
