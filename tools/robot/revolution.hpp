// A closed body of revolution that contains a mesh however it is turned about an axis.
#ifndef FLASHBVH_TOOLS_ROBOT_REVOLUTION_HPP
#define FLASHBVH_TOOLS_ROBOT_REVOLUTION_HPP

#include "bake/mesh.hpp"
#include "robot/kinematics.hpp"

namespace flashbvh::tool {

/// `axis`: a frame, in the mesh's, whose z is the axis. The body goes `margin` beyond the mesh at
/// least: a stack of prisms, each as wide as the mesh in its part of the axis. In one piece, and
/// filled: what lies inside it may be in the mesh's way, too.
bake::SourceMesh revolved(const bake::SourceMesh& mesh, const Transform& axis, double margin);

}  // namespace flashbvh::tool

#endif
