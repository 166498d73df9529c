#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "bake/binary_tree.hpp"

namespace flashbvh::bake {
namespace {

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

/// [node]: the number of triangles below.
std::vector<std::uint32_t> triangle_counts(const BinaryTree& tree) {
  std::vector<std::uint32_t> order = {0};
  for (std::size_t i = 0; i < order.size(); ++i) {
    const BinaryNode& node = tree.nodes[order[i]];
    if (!node.is_leaf()) {
      order.insert(order.end(), node.children.begin(), node.children.end());
    }
  }
  std::vector<std::uint32_t> counts(tree.nodes.size(), 1);
  for (auto node = order.rbegin(); node != order.rend(); ++node) {
    const BinaryNode& at = tree.nodes[*node];
    if (!at.is_leaf()) {
      counts[*node] = counts[at.children[0]] + counts[at.children[1]];
    }
  }
  return counts;
}

/// Merges leaves, cheapest first.
class Merging {
 public:
  explicit Merging(const BinaryTree& tree) : tree_(tree), counts_(triangle_counts(tree)) {
    for (const BinaryNode& node : tree.nodes) {
      is_leaf_.push_back(node.is_leaf());
      leaves_ += node.is_leaf() ? 1 : 0;
    }
    for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
      offer(node);
    }
  }

  /// Down to this number of leaves, and on as long as merges save work.
  std::vector<bool> down_to(std::uint64_t leaves) && {
    while (!offers_.empty() && (leaves_ > leaves || offers_.top().first < 0)) {
      merge(offers_.top().second);
    }
    return std::move(is_leaf_);
  }

 private:
  /// What a leaf costs: the chance to reach it, times a test of it and of its triangles.
  std::int64_t cost(std::uint32_t leaf) const {
    return static_cast<std::int64_t>(tree_.nodes[leaf].surface * (1 + counts_[leaf]));
  }
  void offer(std::uint32_t node) {
    const BinaryNode& at = tree_.nodes[node];
    const auto [first, second] = at.children;
    if (!at.is_leaf() && is_leaf_[first] && is_leaf_[second] && counts_[node] <= kMostByMesh) {
      const std::int64_t more = cost(node) - cost(first) - cost(second);
      offers_.push({more - static_cast<std::int64_t>(at.surface), node});
    }
  }
  void merge(std::uint32_t node) {
    offers_.pop();
    const BinaryNode& at = tree_.nodes[node];
    is_leaf_[at.children[0]] = is_leaf_[at.children[1]] = false;
    is_leaf_[node] = true;
    --leaves_;
    if (at.parent != kNoNode) {
      offer(at.parent);
    }
  }

  using Offer = std::pair<std::int64_t, std::uint32_t>;  ///< additional cost, node

  const BinaryTree& tree_;
  std::vector<std::uint32_t> counts_;
  std::vector<bool> is_leaf_;
  std::uint64_t leaves_ = 0;
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers_;
};

}  // namespace

std::vector<bool> largest_leaves(const BinaryTree& tree, std::uint32_t leaf_size) {
  const std::vector<std::uint32_t> counts = triangle_counts(tree);
  std::vector<bool> is_leaf(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::uint32_t parent = tree.nodes[i].parent;
    is_leaf[i] = counts[i] <= leaf_size && (parent == kNoNode || counts[parent] > leaf_size);
  }
  return is_leaf;
}

std::vector<bool> leaves_by_mesh(const BinaryTree& tree, std::size_t vertices) {
  // Twice the bytes: of an image, of a triangle, of a leaf with its share of nodes, which is 1.56.
  const auto triangles = static_cast<std::int64_t>(tree.nodes.size() + 1) / 2;
  constexpr std::int64_t of_leaf = 2 * (sizeof(LeafSlabs) + 2) + 50;
  const std::int64_t all = 2 * triangles * kBytesByMesh;
  const std::int64_t left = all - 2 * (8 * triangles + 6 * static_cast<std::int64_t>(vertices));
  return Merging(tree).down_to(static_cast<std::uint64_t>(std::max<std::int64_t>(left, 0)) /
                               of_leaf);
}

BuildTree with_leaves(const BinaryTree& tree, const std::vector<bool>& is_leaf) {
  BuildTree built;
  built.nodes.push_back({tree.nodes[0].box, {}, {}});
  std::vector<std::uint32_t> source = {0};  // node of `tree` for each new node
  for (std::uint32_t node = 0; node < built.nodes.size(); ++node) {
    if (is_leaf[source[node]]) {
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
  return with_leaves(tree, leaf_size == kLeavesByMesh ? leaves_by_mesh(tree, mesh.vertices.size())
                                                      : largest_leaves(tree, leaf_size));
}

BuildTree build_default(const LatticeMesh& mesh, std::uint32_t leaf_size) {
  return collapse(build_sah(mesh, leaf_size), kDefaultArity);
}

}  // namespace flashbvh::bake
