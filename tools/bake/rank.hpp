// Ranks: the order in which `ranked` descends.
//
// Two nodes a and b overlap: which one to descend first if the other one follows? Each has k
// children, of which a part p still overlaps. Descending a first takes k_a visits, then k_b for
// each of the p_a k_a pairs left. That is fewer than in the other order if
//   1 - p_a + 1/k_a > 1 - p_b + 1/k_b.
// To first order, 1 - p_a is the sum over the axes of how much shorter a's children are than a, in
// parts of the extents of a and b together. The denominator is the same for a and b. So each side
// is multiplied by its node's own extents and becomes a length that all nodes can compare.
#pragma once

#include <cstdint>

#include "bake/build_tree.hpp"
#include "bake/measure.hpp"

namespace flashbvh::bake {

/// The gain of descending an internal node, in cells, at most 1.5 * 2^17: its extents times
/// (1 - p + 1/2k). Half of the theoretical second term measures better.
inline std::uint32_t rank_measure(const BuildTree& tree, const BuildNode& node) {
  std::uint64_t chances = 0;
  for (const std::uint32_t child : node.children) {
    chances += chance_of_overlap(node.box, tree.nodes[child].box);
  }
  const std::uint64_t count = node.children.size();
  const std::uint64_t gain = kSurely * (2 * count + 1) - 2 * chances;
  return static_cast<std::uint32_t>(cells_sum(node.box) * gain / (2 * kSurely * count));
}

/// A measure on a logarithmic scale of eight steps per octave: 1 (nothing) to 121. Monotone.
/// Below 16 the measure itself; above, its four leading bits after eight for each octave.
constexpr std::uint32_t rank_on_scale(std::uint32_t measure) {
  std::uint32_t shift = 0;
  while ((measure >> shift) >= 16) {
    ++shift;
  }
  return 1 + shift * 8 + (measure >> shift);
}

/// The rank of an internal node, before baking clamps it to its parent's.
inline std::uint32_t rank_of(const BuildTree& tree, const BuildNode& node) {
  return rank_on_scale(rank_measure(tree, node));
}

}  // namespace flashbvh::bake
