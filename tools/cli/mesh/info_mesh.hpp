// The cost of baking a mesh.
#pragma once

#include <string>

namespace flashbvh::tool {

/// Prints the cost for the mesh file at `path`, baked with the finest cell; warns as `bake` does.
void info_of_mesh(const std::string& path, bool json);

}  // namespace flashbvh::tool
