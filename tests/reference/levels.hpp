// The data that the paper's alternating rule needs in addition to a tree: levels, and the path up a
// chain of last children. A reference, no part of the library.
//
// The paper's functions of a node (sections 3, 7 and 8): Level; RCL (right child level: the number
// of last children in the chain from a node upwards, itself included; the root counts as a left
// child); Escape; and LevelUp(i, x), the ancestor x levels above i along last children.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/detail/lattice/image_parts.hpp"
#include "flashbvh/image.hpp"

namespace flashbvh {

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
using PreMeshWithLevels32 = BasicMeshWithLevels<uint32_t, Layout::pre_indexed>;
using MeshWithLevels32 = BasicMeshWithLevels<uint32_t, Layout::post_indexed>;

namespace detail {

template <class Index>
const Index*& climb_of(BasicMeshWithLevels<Index, Layout::pre_indexed>& mesh) {
  return mesh.parents;
}
template <class Index>
const Index*& climb_of(BasicMeshWithLevels<Index, Layout::post_indexed>& mesh) {
  return mesh.right_child_levels;
}

template <class Index, Layout layout>
Status check_tree(BasicMeshWithLevels<Index, layout> mesh, TreeShape& shape) {
  const BasicMesh<Index, layout>& tree = mesh;
  return check_tree(tree, {mesh.levels, climb_of(mesh)}, shape);
}

}  // namespace detail

/// Opens as for a mesh without levels; `image_kind` for an image without levels.
template <class Index, Layout layout>
Status open_image(const void* bytes, size_t size, BasicMeshWithLevels<Index, layout>& mesh) {
  BasicMesh<Index, layout> opened;
  const Status status = open_image(bytes, size, opened);
  mesh = {};
  if (status != Status::done) {
    return status;
  }
  const detail::ImageLevels<Index> levels = detail::image_levels<Index>(bytes);
  if (levels.levels == nullptr) {
    return Status::image_kind;
  }
  static_cast<BasicMesh<Index, layout>&>(mesh) = opened;
  mesh.levels = levels.levels;
  detail::climb_of(mesh) = levels.climb;
  return Status::done;
}

/// As view_unchecked(), for an image baked with levels.
template <class MeshType>
MeshType view_with_levels(const void* image) {
  using Index = typename MeshType::Index;
  using View = BasicMesh<Index, MeshType::kLayout>;
  const detail::ImageLevels<Index> levels = detail::image_levels<Index>(image);
  MeshType mesh;
  static_cast<View&>(mesh) = view_unchecked<View>(image);
  mesh.levels = levels.levels;
  detail::climb_of(mesh) = levels.climb;
  return mesh;
}

}  // namespace flashbvh
