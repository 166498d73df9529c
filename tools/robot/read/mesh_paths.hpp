// Where the meshes of a URDF lie.
#ifndef FLASHBVH_TOOLS_ROBOT_READ_MESH_PATHS_HPP
#define FLASHBVH_TOOLS_ROBOT_READ_MESH_PATHS_HPP

#include <map>
#include <string>

namespace flashbvh::tool {

/// Folders by the names of the ROS packages that they are.
using Packages = std::map<std::string, std::string>;

/// The file that `mesh` means in the URDF `urdf`: a path, relative to the URDF's folder, one behind
/// file://, or package://NAME/REST and model://NAME/REST. The folder NAME is that of `packages`, or
/// else the first of that name, looked for in the URDF's folder and upwards; so it may be any
/// folder next to the URDF, as in files that call no package by its name. UserError, at `place`, if
/// there is no such file.
std::string find_mesh(const std::string& mesh, const std::string& urdf, const Packages& packages,
                      const std::string& place);

}  // namespace flashbvh::tool

#endif
