// Algorithm 3, the alternately stepping stack algorithm: descend into B if the two nodes have the
// same level, else into A; if one of them is a leaf, into the other (section 8.1).
//
// Invariant (property 6.1): while both nodes are internal, level(a) = level(b) or
// level(a) = level(b) - 1. Either layout, with levels.
#ifndef FLASHBVH_PAPER_ALTERNATING_STACK_HPP
#define FLASHBVH_PAPER_ALTERNATING_STACK_HPP

#include <stdint.h>

#include "flashbvh/paper/pair_stack.hpp"

namespace flashbvh {

/// Descends into the node of lower level, into B on ties.
struct AlternatingRule {
  template <class LevelledTree>
  static bool descend_a(const LevelledTree& a, uint32_t node_a, const LevelledTree& b,
                        uint32_t node_b) {
    return a.level(node_a) < b.level(node_b);
  }
};

template <class LevelledTree>
using AlternatingStack = StackOrder<LevelledTree, AlternatingRule>;

}  // namespace flashbvh

#endif
