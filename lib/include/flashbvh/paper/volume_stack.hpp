// Algorithm 2, the volume-based stack algorithm: descend into the box of larger volume, into A on a
// tie (the paper's line 9: into B if the volume of A is less than that of B).
//
// Invariant: the stack holds exactly the pairs that are still to be visited, the next one on top.
// Either layout.
#ifndef FLASHBVH_PAPER_VOLUME_STACK_HPP
#define FLASHBVH_PAPER_VOLUME_STACK_HPP

#include <stdint.h>

#include "flashbvh/paper/pair_stack.hpp"

namespace flashbvh {

/// In cells cubed, below 2^45.
constexpr uint64_t volume(const detail::PackedBox& box) {
  return uint64_t{detail::extent_x(box)} * detail::extent_y(box) * detail::extent_z(box);
}

/// Descends into the larger box, into A on ties.
struct VolumeRule {
  template <class Tree>
  static bool descend_a(const Tree& a, uint32_t node_a, const Tree& b, uint32_t node_b) {
    return volume(a.nodes[node_a].box) >= volume(b.nodes[node_b].box);
  }
};

template <class Tree>
using VolumeStack = StackOrder<Tree, VolumeRule>;

}  // namespace flashbvh

#endif
