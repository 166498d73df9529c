// A URDF, with its meshes and its SRDF, as a Model.
#ifndef FLASHBVH_TOOLS_ROBOT_READ_URDF_HPP
#define FLASHBVH_TOOLS_ROBOT_READ_URDF_HPP

#include <string>

#include "robot/model.hpp"
#include "robot/read/link_mesh.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// `srdf`: a file, or empty. UserError, with the element and the remedy, for all that is no robot
/// or that firmware can't hold; warnings of elements that do not count.
Model read_urdf(const std::string& path, const Packages& packages, const std::string& srdf,
                Warnings& warnings);

}  // namespace flashbvh::tool

#endif
