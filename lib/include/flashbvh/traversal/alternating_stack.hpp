// Algorithm 3 of the paper (section 5), the alternately stepping stack algorithm.
//
// Visits: descends into the node of lower level, into B on ties; if one node is a leaf, into the
// other (section 8.1). stackless.hpp makes the same visits without a stack.
// Needs: trees with levels in either layout (levels.hpp), and a stack in the caller's array
// (pair_stack.hpp); no ranks. Cut into runs, it resumes; it has no cursor to keep.
// Cost: two levels are read at each descent; each pair is pushed and popped once. About 63, 48 and
// 43 instructions a visit on Cortex-M0, M3 and M4F, translated, by boxes.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/walk/stack_order.hpp"
#include "flashbvh/traversal/levels.hpp"

namespace flashbvh {
namespace detail {

/// Descends into the node of lower level, into B on ties; if one is a leaf, into the other (section
/// 8.1). Invariant (property 6.1): while both nodes are inner ones, level(a) = level(b) or
/// level(a) = level(b) - 1.
struct AlternatingRule {
  template <class TreeWithLevels, class Node>
  static Side into(const TreeWithLevels& tree_a, const Node* a, const TreeWithLevels& tree_b,
                   const Node* b) {
    static_assert(HasLevels<TreeWithLevels>::kValue, "alternating-stack needs levels: levels.hpp");
    return side_of(a, b, [&] {
      return tree_a.level(static_cast<uint32_t>(a - tree_a.nodes)) <
             tree_b.level(static_cast<uint32_t>(b - tree_b.nodes));
    });
  }
};

}  // namespace detail

/// The traversal, for Query, on meshes with levels.
template <class TreeWithLevels>
using BasicAlternatingStack = detail::StackOrder<TreeWithLevels, detail::AlternatingRule>;

/// On pre-indexed trees, as in the paper, and on post-indexed ones.
using AlternatingStack = BasicAlternatingStack<PreMeshWithLevels>;
using AlternatingStackPost = BasicAlternatingStack<MeshWithLevels>;

}  // namespace flashbvh
