// The rule of ranked.hpp with a stack: its reference, and its opponent in the benchmark.
//
// Invariant: as algorithm 2. Either layout.
#ifndef FLASHBVH_TRAVERSAL_RANKED_STACK_HPP
#define FLASHBVH_TRAVERSAL_RANKED_STACK_HPP

#include <stdint.h>

#include "flashbvh/traversal/stack_walk.hpp"

namespace flashbvh {

struct RankRule {
  template <class Tree>
  static bool descend_a(const Tree& a, uint32_t node_a, const Tree& b, uint32_t node_b) {
    return a.nodes[node_a].rank() >= b.nodes[node_b].rank();
  }
};

template <class Tree>
using RankedStack = StackWalk<Tree, RankRule>;

}  // namespace flashbvh

#endif
