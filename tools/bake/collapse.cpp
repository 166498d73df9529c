// Collapsing: replaces a node whose test rarely rejects anything by its children (Gu, He and
// Blelloch 2015, "Ray specialized contraction on bounding volume hierarchies", for boxes).
//
// Let p be the chance that a child overlaps an object that its parent overlaps. The child's test
// costs 1 visit, and saves visits to its k children in 1 - p of the cases. The limit for two
// children would be 1/2. A little more measures better: in a walk over two trees, the child is also
// a node at which to descend the other tree.
#include "bake/build_tree.hpp"
#include "bake/measure.hpp"

namespace flashbvh::bake {
namespace {

/// A child less likely to overlap is worth its test: 0.58.
constexpr std::uint64_t kWorthTesting = kSurely * 58 / 100;

/// The position of the internal child with the highest chance of overlap, if its children fit and
/// it is not worth its test, or -1. Ties: the first one.
std::ptrdiff_t child_to_take_in(const BuildTree& tree, const Box& parent,
                                const std::vector<std::uint32_t>& children, std::uint32_t arity) {
  std::ptrdiff_t best = -1;
  std::uint64_t likeliest = kWorthTesting;
  for (std::size_t i = 0; i < children.size(); ++i) {
    const BuildNode& child = tree.nodes[children[i]];
    const std::uint64_t chance = chance_of_overlap(parent, child.box);
    if (!child.is_leaf() && chance > likeliest &&
        children.size() - 1 + child.children.size() <= arity) {
      best = static_cast<std::ptrdiff_t>(i);
      likeliest = chance;
    }
  }
  return best;
}

std::vector<std::uint32_t> widened_children(const BuildTree& tree, std::uint32_t node,
                                            std::uint32_t arity) {
  std::vector<std::uint32_t> children = tree.nodes[node].children;
  for (;;) {
    const std::ptrdiff_t taken = child_to_take_in(tree, tree.nodes[node].box, children, arity);
    if (taken < 0) {
      return children;
    }
    const auto& grandchildren = tree.nodes[children[static_cast<std::size_t>(taken)]].children;
    children.erase(children.begin() + taken);
    children.insert(children.begin() + taken, grandchildren.begin(), grandchildren.end());
  }
}

}  // namespace

BuildTree collapse(const BuildTree& binary, std::uint32_t arity) {
  BuildTree tree;
  tree.nodes.push_back(binary.nodes[0]);
  std::vector<std::uint32_t> source = {0};  // node of `binary` for each new node
  for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
    const std::vector<std::uint32_t> children = widened_children(binary, source[node], arity);
    tree.nodes[node].children.clear();
    for (const std::uint32_t child : children) {
      tree.nodes[node].children.push_back(static_cast<std::uint32_t>(tree.nodes.size()));
      tree.nodes.push_back(binary.nodes[child]);
      source.push_back(child);
    }
  }
  return tree;
}

}  // namespace flashbvh::bake
