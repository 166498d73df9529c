// Ranks: the order in which `ranked` descends.
#ifndef FLASHBVH_TOOLS_BAKE_RANK_HPP
#define FLASHBVH_TOOLS_BAKE_RANK_HPP

#include <cstdint>

#include "bake/build_tree.hpp"

namespace flashbvh::bake {

/// The sum of a box's three extents, in cells; below 2^17.
constexpr std::uint32_t extents_of(const Box& box) {
  return static_cast<std::uint32_t>((box.upper.x - box.lower.x) + (box.upper.y - box.lower.y) +
                                    (box.upper.z - box.lower.z));
}

/// What `ranked` takes for the size of an internal node: how much smaller its children are, on
/// average, than itself, and a quarter of its own extents; in cells, below 2^17. Descending where
/// the boxes shrink most is what makes pairs come apart; the quarter keeps nodes in order whose
/// children are as large as they.
inline std::uint32_t rank_measure(const BuildTree& tree, const BuildNode& node) {
  std::uint64_t children = 0;
  for (const std::uint32_t child : node.children) {
    children += extents_of(tree.nodes[child].box);
  }
  const std::uint64_t own = extents_of(node.box);
  return static_cast<std::uint32_t>(own + own / 4 - children / node.children.size());
}

/// A measure on a logarithmic scale of eight steps an octave: 1 (nothing) to 120. Monotone.
/// Below 16 the measure itself; above, its four leading bits behind eight for each octave.
constexpr std::uint32_t rank_on_scale(std::uint32_t measure) {
  std::uint32_t shift = 0;
  while ((measure >> shift) >= 16) {
    ++shift;
  }
  return 1 + shift * 8 + (measure >> shift);
}

/// Of an internal node, before baking clamps it to its parent's.
inline std::uint32_t rank_of(const BuildTree& tree, const BuildNode& node) {
  return rank_on_scale(rank_measure(tree, node));
}

}  // namespace flashbvh::bake

#endif
