// Two links, one or both of which are the solids that they sweep in a full turn about the joint
// next to them: that joint's angle does not matter then. A solid is a closed body of revolution
// that contains a mesh however it is turned about an axis.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/kinematics.hpp"
#include "robot/matrix/baked_part.hpp"

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

/// A joint next to a link, on the way to the other one.
struct SweptEnd {
  std::size_t link;
  std::size_t joint;
  Transform axis;  ///< in the link's frame
};

/// None if the link's solid of revolution does not do away with a variable.
std::optional<SweptEnd> swept_end(const Model& model, std::size_t link, std::size_t other);

/// The model with solids for links, and the joints about which they turn held.
struct SweptPair {
  Model model;
  double cell;
  BakedPart a;
  BakedPart b;
};

/// With the finest cell, of those twice and twice as large, that takes the solids. A solid holds
/// the link as it is rounded to the lattice, wherever it is rounded to itself; a link that is none
/// is rounded again, up to kDeviation from where it is.
SweptPair swept_pair(const Model& model, std::size_t a, std::size_t b, double cell,
                     const std::vector<SweptEnd>& ends, const Fineness& fineness);

/// Whether any part of `other`, which lies at `frame` and comes nowhere nearer to the solid's
/// surface than a cell of the lattice, lies in the solid.
bool is_any_inside(const WholeMesh& solid, const WholeMesh& other, const Transform& frame,
                   double cell);

}  // namespace flashbvh::tool
