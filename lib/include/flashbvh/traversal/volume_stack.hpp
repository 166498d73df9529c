// Algorithm 2 of the paper (section 4), the dynamic stack algorithm.
//
// Visits: descends into the box of larger volume, into A on ties. The fewest visits of the paper's
// algorithms.
// Needs: a tree in either layout, and a stack in the caller's array (pair_stack.hpp); no levels, no
// ranks. Cut into runs, it resumes; it has no cursor to keep.
// Cost: two volumes, 64-bit products, at each descent; each pair is pushed and popped once. About
// 152, 63 and 56 instructions a visit on Cortex-M0, M3 and M4F, translated, by boxes.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/walk/stack_order.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh {
namespace detail {

/// The volume in cells cubed, below 2^45.
constexpr uint64_t volume(const PackedBox& box) {
  return uint64_t{extent_x(box)} * extent_y(box) * extent_z(box);
}

/// The paper's line 9: into B if A has less volume.
struct VolumeRule {
  template <class Tree, class Node>
  static Side into(const Tree&, const Node* a, const Tree&, const Node* b) {
    return side_of(a, b, [&] { return volume(a->box) >= volume(b->box); });
  }
};

}  // namespace detail

/// The traversal, for Query, on meshes of the type `Tree`.
template <class Tree>
using BasicVolumeStack = detail::StackOrder<Tree, detail::VolumeRule>;

/// On pre-indexed trees, as in the paper, and on post-indexed ones.
using VolumeStack = BasicVolumeStack<PreMesh>;
using VolumeStackPost = BasicVolumeStack<Mesh>;

}  // namespace flashbvh
