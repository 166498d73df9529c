#include "bake/baked_tree.hpp"

#include <algorithm>
#include <cstring>

#include "bake/leaf_slabs.hpp"
#include "bake/quantise.hpp"
#include "bake/rank.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh::bake {
namespace {

/// The tree in array order: all vectors are by array position, all indices are such positions.
struct Traversal {
  std::vector<std::uint32_t> build_nodes;
  std::vector<std::uint32_t> parents;  ///< the root's is itself
  std::vector<std::uint32_t> levels;
  std::vector<std::uint32_t> links;               ///< Node::link
  std::vector<std::uint32_t> right_child_levels;  ///< definition 8.1
  std::vector<std::uint32_t> stack_need;  ///< pairs that a descent to the node leaves on a stack
};

/// Each node before its subtrees, the first subtree first or, if `post`, the last one.
Traversal array_order(const BuildTree& tree, bool post) {
  const std::size_t count = tree.nodes.size();
  std::vector<std::uint32_t> position(count);
  std::vector<std::uint32_t> pending = {0};
  Traversal order;
  while (!pending.empty()) {
    const std::uint32_t node = pending.back();
    pending.pop_back();
    position[node] = static_cast<std::uint32_t>(order.build_nodes.size());
    order.build_nodes.push_back(node);
    const auto& children = tree.nodes[node].children;
    if (post) {
      pending.insert(pending.end(), children.begin(), children.end());
    } else {
      pending.insert(pending.end(), children.rbegin(), children.rend());
    }
  }
  order.parents.assign(count, 0);
  order.levels.assign(count, 0);
  order.links.assign(count, static_cast<std::uint32_t>(count));
  order.right_child_levels.assign(count, 0);
  order.stack_need.assign(count, 0);
  for (std::uint32_t at = 0; at < count; ++at) {
    const auto& children = tree.nodes[order.build_nodes[at]].children;
    for (std::size_t i = 0; i < children.size(); ++i) {
      const std::uint32_t child = position[children[i]];
      const bool is_last = i + 1 == children.size();
      order.parents[child] = at;
      order.levels[child] = order.levels[at] + 1;
      // A last child's is the escape index, definitions 3.1 to 3.3, or the first sibling.
      order.links[child] = !is_last ? position[children[i + 1]]
                           : post   ? position[children.front()]
                                    : order.links[at];
      order.right_child_levels[child] = is_last ? order.right_child_levels[at] + 1 : 0;
      order.stack_need[child] =
          order.stack_need[at] + static_cast<std::uint32_t>(children.size()) - 1;
    }
  }
  return order;
}

/// By array position, clamped to the parent's rank.
std::vector<std::uint32_t> ranks(const Traversal& order, const BuildTree& tree) {
  std::vector<std::uint32_t> ranks(order.build_nodes.size(), 0);
  for (std::size_t at = 0; at < ranks.size(); ++at) {
    const BuildNode& node = tree.nodes[order.build_nodes[at]];
    ranks[at] = node.is_leaf() ? 0 : rank_of(tree, node);
    ranks[at] = std::min(ranks[at], ranks[order.parents[at]]);
  }
  return ranks;
}

template <class Index, Layout layout>
void lay_out_nodes(const Traversal& order, const BuildTree& tree, BakedTree<Index, layout>& baked) {
  const std::vector<std::uint32_t> rank = ranks(order, tree);
  constexpr unsigned rank_shift = Node<Index>::kBits - 8;
  for (std::size_t at = 0; at < order.build_nodes.size(); ++at) {
    const BuildNode& build = tree.nodes[order.build_nodes[at]];
    const std::uint32_t parent_rank =
        at == 0 ? static_cast<std::uint32_t>(kRootParentRank) : rank[order.parents[at]];
    const std::uint32_t data = build.is_leaf() ? Node<Index>::kLeafFlag | baked.leaf_count++
                                               : (rank[at] << rank_shift) | parent_rank;
    baked.nodes.push_back(
        {pack(build.box), static_cast<Index>(order.links[at]), static_cast<Index>(data)});
    baked.depth = std::max(baked.depth, order.levels[at]);
    baked.stack_need = std::max(baked.stack_need, order.stack_need[at]);
    baked.arity = std::max(baked.arity, static_cast<std::uint32_t>(build.children.size()));
  }
}

template <class Index, Layout layout>
void lay_out_triangles(const Traversal& order, const BuildTree& tree, const LatticeMesh& mesh,
                       BakedTree<Index, layout>& baked) {
  for (const std::uint32_t node : order.build_nodes) {
    const auto& triangles = tree.nodes[node].triangles;
    if (tree.nodes[node].is_leaf()) {
      baked.leaf_offsets.push_back(static_cast<Index>(baked.triangles.size()));
      baked.leaf_size = std::max(baked.leaf_size, static_cast<std::uint32_t>(triangles.size()));
      if (layout == Layout::post_indexed) {
        baked.slabs.push_back(leaf_slabs(mesh, triangles));
      }
    }
    for (const std::uint32_t triangle : triangles) {
      const TriangleCorners& corners = mesh.triangles[triangle];
      baked.triangles.push_back({{static_cast<Index>(corners[0]), static_cast<Index>(corners[1]),
                                  static_cast<Index>(corners[2])}});
      baked.triangle_ids.push_back(static_cast<Index>(triangle));
    }
  }
  baked.leaf_offsets.push_back(static_cast<Index>(baked.triangles.size()));
  if (baked.leaf_count == baked.triangles.size()) {
    baked.leaf_offsets.clear();
  }
}

template <class Index>
std::vector<Index> narrowed(const std::vector<std::uint32_t>& wide) {
  std::vector<Index> narrow(wide.size());
  std::transform(wide.begin(), wide.end(), narrow.begin(),
                 [](std::uint32_t value) { return static_cast<Index>(value); });
  return narrow;
}

template <class Index>
bool turn_to_quad(Corners<Index>& u, Corners<Index>& v) {
  for (int turns = 0; turns < 9; ++turns) {
    if (is_quad(u, v)) {
      return true;
    }
    std::rotate(u.corner, u.corner + 1, u.corner + 3);
    if (turns % 3 == 2) {
      std::rotate(v.corner, v.corner + 1, v.corner + 3);
    }
  }
  return false;
}

}  // namespace

template <class Index, Layout layout>
void show_quads(BakedTree<Index, layout>& baked) {
  for (std::size_t leaf = baked.leaf_offsets.size(); leaf > 1; --leaf) {
    const std::size_t first = baked.leaf_offsets[leaf - 2];
    for (std::size_t end = baked.leaf_offsets[leaf - 1]; end > first + 1;) {
      end -= turn_to_quad(baked.triangles[end - 2], baked.triangles[end - 1]) ? 2 : 1;
    }
  }
}

template <class Index, Layout layout>
BakedTree<Index, layout> lay_out(const BuildTree& tree, const LatticeMesh& mesh) {
  BakedTree<Index, layout> baked;
  Traversal order = array_order(tree, layout == Layout::post_indexed);
  lay_out_nodes(order, tree, baked);
  lay_out_triangles(order, tree, mesh, baked);
  baked.levels = narrowed<Index>(order.levels);
  baked.climb =
      narrowed<Index>(layout == Layout::pre_indexed ? order.parents : order.right_child_levels);
  baked.vertices = mesh.vertices;
  baked.origin = mesh.origin;
  baked.cell = mesh.cell;
  baked.deviation = mesh.deviation;
  const Surface surface = surface_of(mesh);
  baked.shell_vertices = narrowed<Index>(surface.shell_vertices);
  baked.longest_edge = surface.longest_edge;
  baked.is_closed = surface.is_closed;
  baked.build_nodes = std::move(order.build_nodes);
  return baked;
}

template <class Index, Layout layout>
BasicMeshWithLevels<Index, layout> BakedTree<Index, layout>::view() const {
  BasicMeshWithLevels<Index, layout> tree{};
  tree.nodes = nodes.data();
  tree.triangles = triangles.data();
  tree.triangle_ids = triangle_ids.data();
  tree.leaf_offsets = leaf_offsets.empty() ? nullptr : leaf_offsets.data();
  tree.slabs = slabs.empty() ? nullptr : slabs.data();
  tree.vertices = vertices.data();
  tree.shell_vertices = shell_vertices.data();
  tree.node_count = static_cast<Index>(nodes.size());
  tree.leaf_count = static_cast<Index>(leaf_count);
  tree.triangle_count = static_cast<Index>(triangles.size());
  tree.vertex_count = static_cast<Index>(vertices.size());
  tree.shell_count = static_cast<Index>(shell_vertices.size());
  tree.stack_need = static_cast<Index>(stack_need);
  tree.longest_edge = longest_edge;
  tree.is_closed = is_closed;
  tree.unit = unit;
  tree.deviation_sixteenths = sixteenths_above(deviation, cell);
  std::copy(origin.begin(), origin.end(), tree.origin);
  static_assert(sizeof tree.cell_bits == sizeof cell);
  std::memcpy(&tree.cell_bits, &cell, sizeof cell);
  tree.levels = levels.data();
  if constexpr (layout == Layout::pre_indexed) {
    tree.parents = climb.data();
  } else {
    tree.right_child_levels = climb.data();
  }
  return tree;
}

#define FLASHBVH_KIND(Index, layout)                                              \
  template struct BakedTree<Index, layout>;                                       \
  template void show_quads(BakedTree<Index, layout>& baked);                      \
  template BakedTree<Index, layout> lay_out<Index, layout>(const BuildTree& tree, \
                                                           const LatticeMesh& mesh);
FLASHBVH_FOR_EACH_KIND(FLASHBVH_KIND)
#undef FLASHBVH_KIND

}  // namespace flashbvh::bake
