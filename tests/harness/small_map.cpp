// What std::map and std::set call where there is no C++ library: steps through a red-black tree,
// and insertion.
//
// Source: Cormen, Leiserson, Rivest and Stein, "Introduction to Algorithms", chapter 13. The header
// node is libstdc++'s: its parent is the root, its left the first node, its right the last; the
// root's parent is the header, which is red, as no root is.
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
  // After the last node the climb may have gone through the header.
  return node->_M_right != above ? above : node;
}

Node* previous_of(Node* node) {
  const bool is_header = node->_M_color == _S_red && node->_M_parent->_M_parent == node;
  if (is_header) {
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

void replace_below(Node* node, Node* by, Node& header) {
  Node* const above = node->_M_parent;
  if (above == &header) {
    header._M_parent = by;
  } else if (above->_M_left == node) {
    above->_M_left = by;
  } else {
    above->_M_right = by;
  }
  by->_M_parent = above;
}

/// The child on the `side` comes up in place of its parent.
void rotate(Node* node, Node* Node::*side, Node& header) {
  Node* Node::*const other = side == &Node::_M_left ? &Node::_M_right : &Node::_M_left;
  Node* const child = node->*side;
  node->*side = child->*other;
  if (node->*side != nullptr) {
    (node->*side)->_M_parent = node;
  }
  replace_below(node, child, header);
  child->*other = node;
  node->_M_parent = child;
}

void recolour(Node* node, Node& header) {
  while (node != header._M_parent && node->_M_parent->_M_color == _S_red) {
    Node* parent = node->_M_parent;
    Node* const above = parent->_M_parent;
    Node* Node::*const side = above->_M_left == parent ? &Node::_M_left : &Node::_M_right;
    Node* Node::*const other = side == &Node::_M_left ? &Node::_M_right : &Node::_M_left;
    Node* const uncle = above->*other;
    if (uncle != nullptr && uncle->_M_color == _S_red) {
      parent->_M_color = uncle->_M_color = _S_black;
      above->_M_color = _S_red;
      node = above;
      continue;
    }
    if (parent->*other == node) {
      rotate(parent, other, header);
      node = parent;
      parent = node->_M_parent;
    }
    parent->_M_color = _S_black;
    above->_M_color = _S_red;
    rotate(above, side, header);
  }
  header._M_parent->_M_color = _S_black;
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
  node->_M_color = _S_red;
  if (left) {
    parent->_M_left = node;  // of the header, too: the first node
    if (parent == &header) {
      header._M_parent = header._M_right = node;
    } else if (parent == header._M_left) {
      header._M_left = node;
    }
  } else {
    parent->_M_right = node;
    if (parent == header._M_right) {
      header._M_right = node;
    }
  }
  recolour(node, header);
}

}  // namespace std
