// The collision elements of a link as one mesh: mesh files, and primitives (primitive_mesh.hpp).
#pragma once

#include <map>
#include <string>

#include "bake/mesh.hpp"
#include "robot/kinematics.hpp"
#include "robot/model.hpp"
#include "robot/read/urdf_document.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Folders by the names of the ROS packages that they are.
using Packages = std::map<std::string, std::string>;

/// Sets the mesh, the sources and the precision of `made`. `to_joint`: from the link's frame to
/// that of its joint. UserError, with the link, if a mesh can't be read, or a size is not positive.
void add_link_mesh(const UrdfLink& link, const Transform& to_joint, const std::string& urdf,
                   const Packages& packages, ModelLink& made, Warnings& warnings);

}  // namespace flashbvh::tool
