#include "bake/baked_tree.hpp"

#include <algorithm>
#include <cstring>

#include "bake/leaf_order.hpp"
#include "bake/quantise.hpp"
#include "bake/rank.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh::bake {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;

/// The shape of the tree in array order; all indices are array positions.
struct Traversal {
  std::vector<std::uint32_t> build_nodes;  ///< by array position
  std::vector<std::uint32_t> parents;      ///< kNone at the root
  std::vector<std::uint32_t> levels;
  std::vector<std::uint32_t> next_sibling;  ///< kNone for a last child
  std::vector<std::uint32_t> first_sibling;
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
  order.parents.assign(count, kNone);
  order.next_sibling.assign(count, kNone);
  order.first_sibling.assign(count, 0);
  order.levels.assign(count, 0);
  order.stack_need.assign(count, 0);
  for (std::uint32_t at = 0; at < count; ++at) {
    const auto& children = tree.nodes[order.build_nodes[at]].children;
    for (std::size_t i = 0; i < children.size(); ++i) {
      const std::uint32_t child = position[children[i]];
      order.parents[child] = at;
      order.levels[child] = order.levels[at] + 1;
      order.stack_need[child] =
          order.stack_need[at] + static_cast<std::uint32_t>(children.size()) - 1;
      order.first_sibling[child] = position[children.front()];
      order.next_sibling[child] = i + 1 < children.size() ? position[children[i + 1]] : kNone;
    }
  }
  return order;
}

/// Definitions 3.1 to 3.3 and 8.1, on array positions. A parent lies before its children.
std::vector<std::uint32_t> escape_indices(const Traversal& order) {
  const std::size_t count = order.build_nodes.size();
  std::vector<std::uint32_t> escapes(count, static_cast<std::uint32_t>(count));
  for (std::size_t at = 1; at < count; ++at) {
    escapes[at] =
        order.next_sibling[at] != kNone ? order.next_sibling[at] : escapes[order.parents[at]];
  }
  return escapes;
}

std::vector<std::uint32_t> right_child_levels(const Traversal& order) {
  std::vector<std::uint32_t> levels(order.build_nodes.size(), 0);
  for (std::size_t at = 1; at < levels.size(); ++at) {
    levels[at] = order.next_sibling[at] != kNone ? 0 : levels[order.parents[at]] + 1;
  }
  return levels;
}

/// By array position, clamped to the parent's rank.
std::vector<std::uint32_t> ranks(const Traversal& order, const BuildTree& tree) {
  std::vector<std::uint32_t> ranks(order.build_nodes.size(), 0);
  for (std::size_t at = 0; at < ranks.size(); ++at) {
    const BuildNode& node = tree.nodes[order.build_nodes[at]];
    ranks[at] = node.is_leaf() ? 0 : rank_of(tree, node);
    if (at != 0) {
      ranks[at] = std::min(ranks[at], ranks[order.parents[at]]);
    }
  }
  return ranks;
}

std::vector<std::uint32_t> links(const Traversal& order, Layout layout) {
  if (layout == Layout::pre_indexed) {
    return escape_indices(order);
  }
  std::vector<std::uint32_t> links(order.build_nodes.size());
  links[0] = static_cast<std::uint32_t>(links.size());
  for (std::size_t at = 1; at < links.size(); ++at) {
    links[at] = order.next_sibling[at] != kNone ? order.next_sibling[at] : order.first_sibling[at];
  }
  return links;
}

template <class Index, Layout layout>
void lay_out_nodes(const Traversal& order, const BuildTree& tree, BakedTree<Index, layout>& baked) {
  const std::vector<std::uint32_t> rank = ranks(order, tree);
  const std::vector<std::uint32_t> link = links(order, layout);
  constexpr unsigned rank_shift = Node<Index>::kBits - 8;
  for (std::size_t at = 0; at < order.build_nodes.size(); ++at) {
    const BuildNode& build = tree.nodes[order.build_nodes[at]];
    const std::uint32_t parent_rank =
        at == 0 ? static_cast<std::uint32_t>(kRootParentRank) : rank[order.parents[at]];
    const std::uint32_t data = build.is_leaf() ? Node<Index>::kLeafFlag | baked.leaf_count++
                                               : (rank[at] << rank_shift) | parent_rank;
    baked.nodes.push_back(
        {pack(build.box), static_cast<Index>(link[at]), static_cast<Index>(data)});
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
    }
    for (const std::uint32_t triangle : leaf_order(mesh, triangles)) {
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
  order.parents[0] = 0;
  baked.climb =
      narrowed<Index>(layout == Layout::pre_indexed ? order.parents : right_child_levels(order));
  baked.vertices = mesh.vertices;
  baked.origin = mesh.origin;
  baked.cell = mesh.cell;
  baked.deviation = mesh.deviation;
  const Surface surface = surface_of(mesh);
  baked.shell_vertices = narrowed<Index>(surface.shell_vertices);
  baked.longest_edge = surface.longest_edge;
  baked.is_closed = surface.is_closed;
  baked.unit = mesh.unit;
  baked.name = mesh.name.substr(0, kMaxNameSize);
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
