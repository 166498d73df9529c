// Two links, one or both replaced by the solids that they sweep in a full turn about the joint next
// to them, which removes that joint's angle. A solid is a closed body of revolution that contains a
// mesh at every angle about an axis.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/kinematics.hpp"
#include "robot/matrix/baked_part.hpp"

namespace flashbvh::tool {

/// The number of a solid's sides, and of its slabs along the axis. `by_heights`: also cuts at the
/// heights of the mesh's vertices, unless they are too many for `slabs`.
struct Fineness {
  std::uint32_t slabs;
  std::uint32_t sides;
  double alike;  ///< widths with a smaller relative difference are merged
  bool by_heights;
};
constexpr Fineness kCoarse{16, 32, 0.02, false};
constexpr Fineness kFine{128, 48, 0.001, true};

/// `axis`: a frame in the mesh's frame, whose z is the axis. The solid exceeds the mesh by `margin`
/// or more: a stack of prisms, each as wide as the mesh in its slab. It is connected and filled:
/// an object inside it may collide with the mesh, too.
bake::SourceMesh revolved(const bake::SourceMesh& mesh, const Transform& axis, double margin,
                          const Fineness& fineness);

/// A joint next to a link, on the path to the other link.
struct SweptEnd {
  std::size_t link;
  std::size_t joint;
  Transform axis;  ///< in the link's frame
};

/// None if the link's solid of revolution would remove no variable.
std::optional<SweptEnd> swept_end(const Model& model, std::size_t link, std::size_t other);

/// The model with solids for links, and with the joints of their axes held.
struct SweptPair {
  Model model;
  std::size_t link_a;
  std::size_t link_b;
  double cell;
  BakedPart a;
  BakedPart b;
};

/// Bakes with the finest cell of `cell`, 2 `cell`, 4 `cell`, ... that holds the solids. A rounded
/// solid contains the link as rounded to the lattice. A link without a solid is rounded again, by
/// up to kDeviation.
SweptPair swept_pair(const Model& model, std::size_t a, std::size_t b, double cell,
                     const std::vector<SweptEnd>& ends, const Fineness& fineness);

/// True if at these values of the variables a part of the other link lies in the solid of `end`.
/// The other link has to be more than a cell away from the solid's surface.
bool is_any_inside(const SweptPair& pair, const SweptEnd& end,
                   const std::vector<double>& variables);

}  // namespace flashbvh::tool
