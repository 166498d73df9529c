// The functions of std::map and std::set without a C++ library: steps through a binary tree, and
// insertion. The tests' maps are small, so trees are not balanced.
//
// The header node is libstdc++'s: its parent is the root, its left the first node, its right the
// last; the root's parent is the header, which alone is red.
#include <map>

namespace std {
namespace {

using Node = _Rb_tree_node_base;

Node* next_of(Node* node) {
  if (node->_M_right != nullptr) {
    return Node::_S_minimum(node->_M_right);
  }
  Node* above = node->_M_parent;
  while (node == above->_M_right) {
    node = above;
    above = above->_M_parent;
  }
  // After the last node, the climb may have passed the header.
  return node->_M_right != above ? above : node;
}

Node* previous_of(Node* node) {
  if (node->_M_color == _S_red) {
    return node->_M_right;
  }
  if (node->_M_left != nullptr) {
    return Node::_S_maximum(node->_M_left);
  }
  Node* above = node->_M_parent;
  while (node == above->_M_left) {
    node = above;
    above = above->_M_parent;
  }
  return above;
}

}  // namespace

Node* _Rb_tree_increment(Node* node) throw() {
  return next_of(node);
}
const Node* _Rb_tree_increment(const Node* node) throw() {
  return next_of(const_cast<Node*>(node));
}
Node* _Rb_tree_decrement(Node* node) throw() {
  return previous_of(node);
}
const Node* _Rb_tree_decrement(const Node* node) throw() {
  return previous_of(const_cast<Node*>(node));
}

void _Rb_tree_insert_and_rebalance(const bool left, Node* node, Node* parent,
                                   Node& header) throw() {
  node->_M_parent = parent;
  node->_M_left = node->_M_right = nullptr;
  node->_M_color = _S_black;
  (left ? parent->_M_left : parent->_M_right) = node;  // also sets the header's first node
  if (parent == &header) {
    header._M_parent = header._M_right = node;
  } else if (left && parent == header._M_left) {
    header._M_left = node;
  } else if (!left && parent == header._M_right) {
    header._M_right = node;
  }
}

}  // namespace std
