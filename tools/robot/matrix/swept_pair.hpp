// Two links, one or both of which are the solids that they sweep in a full turn about the joint
// next to them: that joint's angle does not matter then.
#ifndef FLASHBVH_TOOLS_ROBOT_MATRIX_SWEPT_PAIR_HPP
#define FLASHBVH_TOOLS_ROBOT_MATRIX_SWEPT_PAIR_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include "bake/baked_tree.hpp"
#include "robot/kinematics.hpp"
#include "robot/matrix/revolution.hpp"

namespace flashbvh::tool {

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
  using Baked = bake::BakedTree<std::uint16_t, Layout::post_indexed>;

  Model model;
  double cell;
  Baked a;
  Baked b;
};

/// With the finest cell, of those twice and twice as large, that takes the solids. A solid holds
/// the link as it is rounded to the lattice, wherever it is rounded to itself; a link that is none
/// is rounded again, up to kDeviation from where it is.
SweptPair swept_pair(const Model& model, std::size_t a, std::size_t b, double cell,
                     const std::vector<SweptEnd>& ends, const Fineness& fineness);

/// Whether any part of `other`, which lies at `frame` and comes nowhere nearer to the solid's
/// surface than a cell of the lattice, lies in the solid.
bool is_any_inside(const Mesh& solid, const Mesh& other, const Transform& frame, double cell);

}  // namespace flashbvh::tool

#endif
