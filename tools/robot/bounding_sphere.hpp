// A sphere that holds a mesh.
#ifndef FLASHBVH_TOOLS_ROBOT_BOUNDING_SPHERE_HPP
#define FLASHBVH_TOOLS_ROBOT_BOUNDING_SPHERE_HPP

#include <array>
#include <cstdint>

#include "flashbvh/mesh.hpp"

namespace flashbvh::tool {

/// In cells.
struct BoundingSphere {
  std::array<double, 3> centre;
  double radius;
};

/// Within 1 % of the smallest (Badoiu and Clarkson, "Smaller core-sets for balls", 2003).
BoundingSphere bounding_sphere(const PostMesh& mesh);

}  // namespace flashbvh::tool

#endif
