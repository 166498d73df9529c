// The collision elements of a link as one mesh.
#ifndef FLASHBVH_TOOLS_ROBOT_READ_LINK_MESH_HPP
#define FLASHBVH_TOOLS_ROBOT_READ_LINK_MESH_HPP

#include <string>

#include "robot/model.hpp"
#include "robot/read/mesh_paths.hpp"
#include "robot/read/urdf_document.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Sets the mesh, the sources and the precision of `made`. `to_joint`: from the link's frame to
/// that of its joint. UserError, with the link, if a mesh can't be read, or a size is not positive.
void add_link_mesh(const UrdfLink& link, const Transform& to_joint, const std::string& urdf,
                   const Packages& packages, ModelLink& made, Warnings& warnings);

}  // namespace flashbvh::tool

#endif
