#include "report/tree_shape.hpp"

namespace flashbvh::report {
namespace {

void count(Histogram& histogram, std::size_t number) {
  if (histogram.size() <= number) {
    histogram.resize(number + 1, 0);
  }
  ++histogram[number];
}

/// In both layouts a node comes before its subtree: its parent is the latest node one level up.
template <class Levelled>
Histogram children_of_nodes(const Levelled& tree) {
  Histogram children(tree.node_count, 0);
  std::vector<std::uint32_t> latest;  // by depth
  for (std::uint32_t node = 0; node < tree.node_count; ++node) {
    const std::uint32_t depth = tree.level(node);
    latest.resize(depth);
    if (depth != 0) {
      ++children[latest.back()];
    }
    latest.push_back(node);
  }
  return children;
}

template <class Levelled>
TreeShape shape(const Levelled& tree) {
  TreeShape shape;
  const Histogram children = children_of_nodes(tree);
  for (std::uint32_t i = 0; i < tree.node_count; ++i) {
    const auto& node = tree.nodes[i];
    count(shape.nodes_by_depth, tree.level(i));
    if (node.is_leaf()) {
      count(shape.leaves_by_depth, tree.level(i));
      count(shape.leaves_by_size,
            tree.end_triangle(node.leaf()) - tree.first_triangle(node.leaf()));
    } else {
      count(shape.nodes_by_children, children[i]);
    }
  }
  return shape;
}

}  // namespace

TreeShape shape_of(const tool::AnyTree& any) {
  return std::visit([](const auto& tree) { return shape(tree); }, any);
}

std::vector<NodeBox> boxes_at(const tool::AnyTree& any, std::uint32_t depth) {
  return std::visit(
      [&](const auto& tree) {
        std::vector<NodeBox> boxes;
        for (std::uint32_t i = 0; i < tree.node_count; ++i) {
          if (tree.level(i) == depth) {
            boxes.push_back({detail::unpack(tree.nodes[i].box), tree.nodes[i].is_leaf()});
          }
        }
        return boxes;
      },
      any);
}

}  // namespace flashbvh::report
