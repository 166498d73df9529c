// Joins a link's collision elements into one mesh: mesh files and primitives (primitive_mesh.hpp).
#pragma once

#include <map>
#include <string>

#include "bake/mesh.hpp"
#include "robot/kinematics.hpp"
#include "robot/model.hpp"
#include "robot/read/urdf_document.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Folders of ROS packages, by the packages' names.
using Packages = std::map<std::string, std::string>;

/// Sets the mesh, the sources and the precision of `made`. `to_joint`: from the link's frame to its
/// joint's. UserError, with the link, if a mesh can't be read, or a size is not positive.
void add_link_mesh(const UrdfLink& link, const Transform& to_joint, const std::string& urdf,
                   const Packages& packages, ModelLink& made, Warnings& warnings);

}  // namespace flashbvh::tool
