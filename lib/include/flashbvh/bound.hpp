// What queries can cost at worst, for static_assert: the formulas of lib/docs/bounded_time.md.
//
//     static_assert(flashbvh::most_visits(arm::kLeafCount, cell::kLeafCount) < 1000000);
//     static_assert(flashbvh::most_instructions(kMyCore, kMyTrees, {100, 20}) < 100000);
#ifndef FLASHBVH_BOUND_HPP
#define FLASHBVH_BOUND_HPP

#include <stdint.h>

namespace flashbvh {

/// The most visits of a whole query by any traversal, at any pose, on two meshes with so many
/// leaves, whose nodes have two children or more each, as `flashbvh bake` makes them. For two
/// images and `ranked`, `flashbvh collide --bound` knows the exact number, which is lower.
constexpr uint64_t most_visits(uint32_t leaves_a, uint32_t leaves_b) {
  return 2 * static_cast<uint64_t>(leaves_a) * leaves_b - 1;
}

/// Instructions that each part of a run can take at most on some core, with some compiler; what
/// `ctest -R "bound:" -V` prints as `bound NAME`.
struct RunCosts {
  uint32_t run;            ///< once
  uint32_t visit;          ///< each visit
  uint32_t ascent;         ///< each ascent to a parent
  uint32_t leaf_pair;      ///< beside its visit, each pair of leaves whose boxes overlap
  uint32_t later_sibling;  ///< each sibling after the node where a walk goes on
  uint32_t triangle_pair;  ///< each pair of triangles transformed and tested
  uint32_t leaf_triangle;  ///< each visit, for each triangle that its leaf has beside the first
};

/// What of two meshes has a part in a run's cost: constants of their baked headers.
struct TreePair {
  uint32_t depths;               ///< kDepth of A and of B added
  uint32_t later_siblings;       ///< kArity - 1 of A and of B added, 0 for a root that is a leaf
  uint32_t triangle_pairs;       ///< kLeafSize of A times that of B
  uint32_t other_triangles = 0;  ///< the larger kLeafSize, less 1
};

struct RunLimits {
  uint32_t visits;      ///< the run's argument
  uint32_t leaf_pairs;  ///< visits to pairs of leaves that overlap: `visits` if unknown
};

/// The most instructions of PairQuery::run(limits.visits, found), from `run` called to returned.
constexpr uint64_t most_instructions(const RunCosts& costs, const TreePair& trees,
                                     const RunLimits& limits) {
  const uint64_t walk = static_cast<uint64_t>(trees.later_siblings) * costs.later_sibling;
  // An array that was full leaves the triangles of one more pair of leaves.
  const uint64_t tested = (uint64_t{1} + limits.leaf_pairs) * trees.triangle_pairs;
  return costs.run + walk + static_cast<uint64_t>(trees.depths) * costs.ascent +
         static_cast<uint64_t>(limits.visits) *
             (costs.visit + uint64_t{costs.leaf_triangle} * trees.other_triangles) +
         static_cast<uint64_t>(limits.visits - limits.leaf_pairs) * costs.ascent +
         limits.leaf_pairs * (costs.leaf_pair + walk) + tested * costs.triangle_pair;
}

/// The most visits N for which run(N, found) stays within so many instructions, whatever it comes
/// to; 0 if none does.
constexpr uint32_t visits_within(uint64_t instructions, const RunCosts& costs,
                                 const TreePair& trees) {
  const uint64_t none = most_instructions(costs, trees, {0, 0});
  const uint64_t all_leaves = most_instructions(costs, trees, {1, 1}) - none;
  const uint64_t no_leaves = most_instructions(costs, trees, {1, 0}) - none;
  const uint64_t each = all_leaves > no_leaves ? all_leaves : no_leaves;
  if (instructions < none || each == 0) {
    return 0;
  }
  const uint64_t visits = (instructions - none) / each;
  return visits < UINT32_MAX ? static_cast<uint32_t>(visits) : UINT32_MAX;
}

}  // namespace flashbvh

#endif
