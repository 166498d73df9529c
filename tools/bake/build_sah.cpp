#include "bake/binary_tree.hpp"

namespace flashbvh::bake {
namespace {

/// The triangles below a node, from its first child to its last; none if they are more than `most`.
std::vector<std::uint32_t> triangles_below(const BinaryTree& tree, std::uint32_t node,
                                           std::size_t most) {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> pending = {node};
  while (!pending.empty()) {
    if (triangles.size() + pending.size() > most) {
      return {};
    }
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

BuildTree with_leaves(const BinaryTree& tree, std::uint32_t leaf_size) {
  BuildTree built;
  built.nodes.push_back({tree.nodes[0].box, {}, {}});
  std::vector<std::uint32_t> source = {0};  // node of `tree` for each new node
  for (std::uint32_t node = 0; node < built.nodes.size(); ++node) {
    built.nodes[node].triangles = triangles_below(tree, source[node], leaf_size);
    if (!built.nodes[node].triangles.empty()) {
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
