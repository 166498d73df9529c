// Meshes with the arrays that the paper's alternating rule needs in addition to a tree: levels, and
// the path up a chain of last children.
//
// The paper's functions of a node (sections 3, 7 and 8): Level; RCL (right child level: the number
// of last children in the chain from a node upwards, itself included; the root counts as a left
// child); Escape; and LevelUp(i, x), the ancestor x levels above i along last children.
//
// `flashbvh bake --layout pre` and `--layout post --levels` write the arrays: two indices a node.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/image.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh {

/// A mesh with levels: a view, as BasicMesh.
template <class Index, Layout layout>
struct BasicMeshWithLevels;

/// Pre-indexed (section 7): LevelUp goes from parent to parent.
template <class IndexType>
struct BasicMeshWithLevels<IndexType, Layout::pre_indexed>
    : BasicMesh<IndexType, Layout::pre_indexed> {
  const IndexType* levels;   ///< node_count: the depth of the node, 0 at the root
  const IndexType* parents;  ///< node_count: the index of the parent; 0 at the root

  /// The paper's Level.
  uint32_t level(uint32_t node) const { return levels[node]; }
  /// The paper's Escape.
  uint32_t escape(uint32_t node) const { return this->nodes[node].link; }
  /// Replaces a node by its escape index; returns 0 if this is the end node.
  uint32_t escape_from(uint32_t& node, uint32_t /*rcl*/) const {
    node = escape(node);
    return this->node_count - node;
  }
  /// A node's escape index is the next sibling of the first left child above it, so the levels of
  /// the two differ by the RCL; the end node has level 0.
  uint32_t rcl(uint32_t node) const {
    const uint32_t to = escape(node);
    return to == this->node_count ? level(node) : level(node) - level(to);
  }
  /// The paper's LevelUp.
  uint32_t level_up(uint32_t node, uint32_t count) const {
    for (; count != 0; --count) {
      node = parents[node];
    }
    return node;
  }
};

/// Post-indexed (section 8.3): LevelUp(i, x) = i - x.
template <class IndexType>
struct BasicMeshWithLevels<IndexType, Layout::post_indexed>
    : BasicMesh<IndexType, Layout::post_indexed> {
  const IndexType* levels;              ///< node_count: the depth of the node, 0 at the root
  const IndexType* right_child_levels;  ///< node_count: RCL

  /// The paper's Level.
  uint32_t level(uint32_t node) const { return levels[node]; }
  /// The paper's RCL.
  uint32_t rcl(uint32_t node) const { return right_child_levels[node]; }
  /// The paper's LevelUp.
  uint32_t level_up(uint32_t node, uint32_t count) const { return node - count; }
  /// The link of the first left child above the node.
  uint32_t escape(uint32_t node) const { return this->nodes[node - rcl(node)].link; }
  /// Replaces a node of known RCL by its escape index; returns 0 if it is the end node: the root's.
  uint32_t escape_from(uint32_t& node, uint32_t rcl) const {
    const uint32_t left_child = node - rcl;
    node = this->nodes[left_child].link;
    return left_child;
  }
};

using PreMeshWithLevels = BasicMeshWithLevels<uint16_t, Layout::pre_indexed>;
using MeshWithLevels = BasicMeshWithLevels<uint16_t, Layout::post_indexed>;

/// Tells the types of meshes with levels.
template <class MeshType>
struct HasLevels {
  static constexpr bool kValue = false;  ///< true if it has levels
};
/// Has levels.
template <class Index, Layout layout>
struct HasLevels<BasicMeshWithLevels<Index, layout>> {
  static constexpr bool kValue = true;  ///< it has
};

/// Opens an image as open_image() of image.hpp does. `image_kind` also for an image without levels.
template <class Index, Layout layout>
Status open_image(const void* bytes, size_t size, BasicMeshWithLevels<Index, layout>& mesh);

/// As view_unchecked() of image.hpp. A mesh of an image without levels is not open: queries return
/// `not_open`.
template <>
PreMeshWithLevels view_unchecked<PreMeshWithLevels>(const void* image);
/// The same, post-indexed.
template <>
MeshWithLevels view_unchecked<MeshWithLevels>(const void* image);

}  // namespace flashbvh
