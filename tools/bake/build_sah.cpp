#include "bake/binary_tree.hpp"

namespace flashbvh::bake {
namespace {

/// Parents before their children.
std::vector<std::uint32_t> top_down(const BinaryTree& tree) {
  std::vector<std::uint32_t> order = {0};
  for (std::size_t i = 0; i < order.size(); ++i) {
    const BinaryNode& node = tree.nodes[order[i]];
    if (!node.is_leaf()) {
      order.insert(order.end(), node.children.begin(), node.children.end());
    }
  }
  return order;
}

/// The number of triangles below each node.
std::vector<std::uint32_t> triangle_counts(const BinaryTree& tree) {
  std::vector<std::uint32_t> counts(tree.nodes.size(), 1);
  const std::vector<std::uint32_t> order = top_down(tree);
  for (auto node = order.rbegin(); node != order.rend(); ++node) {
    if (!tree.nodes[*node].is_leaf()) {
      const auto& children = tree.nodes[*node].children;
      counts[*node] = counts[children[0]] + counts[children[1]];
    }
  }
  return counts;
}

/// The triangles below a node, from its first child to its last.
std::vector<std::uint32_t> triangles_below(const BinaryTree& tree, std::uint32_t node) {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> pending = {node};
  while (!pending.empty()) {
    const BinaryNode& at = tree.nodes[pending.back()];
    pending.pop_back();
    if (at.is_leaf()) {
      triangles.push_back(at.triangle);
    } else {
      pending.insert(pending.end(), at.children.rbegin(), at.children.rend());
    }
  }
  return triangles;
}

}  // namespace

std::uint64_t cost_of(const BinaryTree& tree) {
  std::uint64_t cost = 0;
  for (const BinaryNode& node : tree.nodes) {
    cost += node.is_leaf() ? 0 : node.surface;
  }
  return cost;
}

BuildTree with_leaves(const BinaryTree& tree, std::uint32_t leaf_size) {
  const std::vector<std::uint32_t> counts = triangle_counts(tree);
  BuildTree built;
  built.nodes.push_back({tree.nodes[0].box, {}, {}});
  std::vector<std::uint32_t> source = {0};  // node of `tree` for each new node
  for (std::uint32_t node = 0; node < built.nodes.size(); ++node) {
    if (counts[source[node]] <= leaf_size) {
      built.nodes[node].triangles = triangles_below(tree, source[node]);
      continue;
    }
    for (const std::uint32_t child : tree.nodes[source[node]].children) {
      built.nodes[node].children.push_back(static_cast<std::uint32_t>(built.nodes.size()));
      built.nodes.push_back({tree.nodes[child].box, {}, {}});
      source.push_back(child);
    }
  }
  return built;
}

BuildTree build_sah(const LatticeMesh& mesh, std::uint32_t leaf_size) {
  BinaryTree tree = sweep(mesh);
  reinsert_all(tree);
  return with_leaves(tree, leaf_size);
}

BuildTree build_default(const LatticeMesh& mesh, std::uint32_t leaf_size) {
  return collapse(build_sah(mesh, leaf_size), kDefaultArity);
}

}  // namespace flashbvh::bake
