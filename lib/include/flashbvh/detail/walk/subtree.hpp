// The walk over the nodes below one node of a tree, parents first, in the order of the traversals.
#pragma once

#include <stdint.h>

#include "flashbvh/mesh.hpp"

namespace flashbvh::detail {

template <class IndexType, Layout layout>
class Subtree;

/// A subtree ends before the escape index of its root.
template <class IndexType>
class Subtree<IndexType, Layout::pre_indexed> {
  using NodeType = Node<IndexType>;

 public:
  /// Starts at `node`, which is `root` or lies below it.
  Subtree(const Tree<IndexType, Layout::pre_indexed>& tree, uint32_t root, uint32_t node)
      : nodes_(tree.nodes), end_(nodes_ + nodes_[root].link), node_(nodes_ + node) {}

  const NodeType& node() const { return *node_; }
  uint32_t node_index() const { return static_cast<uint32_t>(node_ - nodes_); }
  /// Moves to the first child of an internal node.
  void descend() { ++node_; }
  /// Moves to the next node outside this node's subtree; false if there is none.
  bool next() {
    node_ = nodes_ + node_->link;
    return node_ != end_;
  }

 private:
  const NodeType* nodes_;
  const NodeType* end_;
  const NodeType* node_;
};

/// A node without a later sibling lies right after its parent.
template <class IndexType>
class Subtree<IndexType, Layout::post_indexed> {
  using NodeType = Node<IndexType>;

 public:
  Subtree(const Tree<IndexType, Layout::post_indexed>& tree, uint32_t root, uint32_t node)
      : nodes_(tree.nodes), root_(nodes_ + root), node_(nodes_ + node) {}

  const NodeType& node() const { return *node_; }
  uint32_t node_index() const { return static_cast<uint32_t>(node_ - nodes_); }
  void descend() { node_ = nodes_ + node_[1].link; }
  bool next() {
    while (node_ != root_) {
      const NodeType* const sibling = nodes_ + node_->link;
      if (sibling < node_) {
        node_ = sibling;
        return true;
      }
      --node_;
    }
    return false;
  }

 private:
  const NodeType* nodes_;
  const NodeType* root_;
  const NodeType* node_;
};

}  // namespace flashbvh::detail
