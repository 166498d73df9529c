// What a user should hear about a mesh's surface, from `bake` and `check` alike.
#ifndef FLASHBVH_TOOLS_CLI_SURFACE_HPP
#define FLASHBVH_TOOLS_CLI_SURFACE_HPP

#include <string>

#include "mesh/defects.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Warns of a surface that is not closed, or not oriented, or inside out. `path`: the mesh or
/// image.
void warn_of_surface(const MeshDefects& defects, const std::string& path, Warnings& warnings);

}  // namespace flashbvh::tool

#endif
