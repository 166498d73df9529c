// A closed body of revolution that contains a mesh however it is turned about an axis.
#ifndef FLASHBVH_TOOLS_ROBOT_MATRIX_REVOLUTION_HPP
#define FLASHBVH_TOOLS_ROBOT_MATRIX_REVOLUTION_HPP

#include "bake/mesh.hpp"
#include "robot/kinematics.hpp"

namespace flashbvh::tool {

/// How many sides a solid has, and how many parts along its axis. `by_heights`: cut where the mesh
/// has vertices, too, while that leaves no more than `slabs`.
struct Fineness {
  std::uint32_t slabs;
  std::uint32_t sides;
  double alike;  ///< widths that differ by less than this part are the same
  bool by_heights;
};
constexpr Fineness kCoarse{16, 32, 0.02, false};
constexpr Fineness kFine{128, 48, 0.001, true};

/// `axis`: a frame, in the mesh's, whose z is the axis. The body goes `margin` beyond the mesh at
/// least: a stack of prisms, each as wide as the mesh in its part of the axis. In one piece, and
/// filled: what lies inside it may be in the mesh's way, too.
bake::SourceMesh revolved(const bake::SourceMesh& mesh, const Transform& axis, double margin,
                          const Fineness& fineness);

}  // namespace flashbvh::tool

#endif
