// What the alternating rule needs beside the tree: levels, and the way up a chain of last children.
//
// The paper's functions of a node (sections 3, 7 and 8): Level, RCL (right child level: how many
// last children lie straight above a node, itself included; the root counts as a left child),
// Escape, and LevelUp(i, x), the ancestor x levels above i along last children.
//
// Levels live in arrays of their own, 4 bytes a node: firmware that does not use the alternating
// traversals does not link them.
#ifndef FLASHBVH_LEVELS_HPP
#define FLASHBVH_LEVELS_HPP

#include <stdint.h>

#include "flashbvh/tree.hpp"

namespace flashbvh {

template <class Index, Layout layout>
struct LevelledTree;

/// Pre-indexed (section 7): LevelUp goes from parent to parent.
template <class IndexType>
struct LevelledTree<IndexType, Layout::pre_indexed> : Tree<IndexType, Layout::pre_indexed> {
  const IndexType* levels;   ///< node_count: the depth of the node, 0 at the root
  const IndexType* parents;  ///< node_count: the index of the parent; 0 at the root

  uint32_t level(uint32_t node) const { return levels[node]; }
  uint32_t escape(uint32_t node) const { return this->nodes[node].link; }
  uint32_t escape(uint32_t node, uint32_t /*rcl*/) const { return escape(node); }
  /// A node's escape index is the next sibling of the first left child above it, so the levels of
  /// the two differ by the RCL; the end node has level 0.
  uint32_t rcl(uint32_t node) const {
    const uint32_t to = escape(node);
    return to == this->node_count ? level(node) : level(node) - level(to);
  }
  uint32_t level_up(uint32_t node, uint32_t count) const {
    for (; count != 0; --count) {
      node = parents[node];
    }
    return node;
  }
};

/// Post-indexed (section 8.3): LevelUp(i, x) = i - x.
template <class IndexType>
struct LevelledTree<IndexType, Layout::post_indexed> : Tree<IndexType, Layout::post_indexed> {
  const IndexType* levels;              ///< node_count: the depth of the node, 0 at the root
  const IndexType* right_child_levels;  ///< node_count: RCL

  uint32_t level(uint32_t node) const { return levels[node]; }
  uint32_t rcl(uint32_t node) const { return right_child_levels[node]; }
  uint32_t level_up(uint32_t node, uint32_t count) const { return node - count; }
  uint32_t escape(uint32_t node) const { return escape(node, rcl(node)); }
  /// The link of the first left child above the node, whose RCL is known.
  uint32_t escape(uint32_t node, uint32_t rcl) const { return this->nodes[node - rcl].link; }
};

using LevelledPreTree = LevelledTree<uint16_t, Layout::pre_indexed>;
using LevelledPostTree = LevelledTree<uint16_t, Layout::post_indexed>;
using LargeLevelledPreTree = LevelledTree<uint32_t, Layout::pre_indexed>;
using LargeLevelledPostTree = LevelledTree<uint32_t, Layout::post_indexed>;

}  // namespace flashbvh

#endif
