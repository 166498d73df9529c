// Counts pairs instead of walking them.
//
// `ranked` reaches a pair (a, b) through the proper ancestors of both nodes, in merged order of
// rank, A's first on ties. If all boxes overlap, it visits the pair exactly if it descends into
// each ancestor of a before b, and into each ancestor of b before a. The last ancestors, the
// parents, have the smallest ranks. So it visits (a, b) exactly if
//     rank(parent(a)) >= rank(b)   and   rank(parent(b)) > rank(a),
// where a leaf's rank is 0 and a root's parent is above all. There are few ranks, so nodes are
// counted by their own and their parent's rank.
//
// `stackless` visits a pair at most once. If all inner nodes have at least two children,
// the visits form a tree whose inner nodes have at least two children, and whose leaves are at most
// all pairs of leaves.
#include "evaluate/needed_work.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "flashbvh/time_bound.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::size_t kRanks = std::size_t{kRootParentRank} + 1;

/// Counts of nodes by the rank of their parent and their own rank.
using RankCounts = std::array<std::array<std::uint64_t, kRanks>, kRanks>;

/// Calls `visit(child, parent)` for each node except the root.
template <class Tree, class Visit>
void for_each_child(const Tree& tree, const Visit& visit) {
  for (std::uint32_t parent = 0; parent < tree.node_count; ++parent) {
    if (tree.nodes[parent].is_leaf()) {
      continue;
    }
    for (std::uint32_t child = tree.first_child(parent);; child = tree.next_sibling(child)) {
      visit(child, parent);
      if (tree.is_last_child(parent, child)) {
        break;
      }
    }
  }
}

template <class Tree>
RankCounts count_ranks(const Tree& tree) {
  RankCounts counts{};
  const auto rank = [&](std::uint32_t node) {
    return static_cast<std::size_t>(std::max<std::int32_t>(tree.nodes[node].rank(), 0));
  };
  ++counts[kRootParentRank][rank(0)];
  for_each_child(tree, [&](std::uint32_t child, std::uint32_t parent) {
    ++counts[rank(parent)][rank(child)];
  });
  return counts;
}

/// at_least[p][r]: nodes with a parent of rank p or more and an own rank of r or less.
RankCounts accumulate(RankCounts counts) {
  for (std::size_t parent = kRanks; parent-- != 0;) {
    for (std::size_t own = 0; own < kRanks; ++own) {
      counts[parent][own] += (parent + 1 < kRanks ? counts[parent + 1][own] : 0) +
                             (own > 0 ? counts[parent][own - 1] : 0) -
                             (parent + 1 < kRanks && own > 0 ? counts[parent + 1][own - 1] : 0);
    }
  }
  return counts;
}

template <class Tree>
std::uint64_t ranked_visits(const Tree& a, const Tree& b) {
  const RankCounts of_a = count_ranks(a);
  const RankCounts of_b = accumulate(count_ranks(b));
  std::uint64_t visits = 0;
  for (std::size_t parent = 0; parent < kRanks; ++parent) {
    for (std::size_t own = 0; own + 1 < kRanks; ++own) {
      visits += of_a[parent][own] * of_b[own + 1][parent];
    }
  }
  return visits;
}

template <class Tree>
bool has_single_child(const Tree& tree) {
  bool found = false;
  for_each_child(tree, [&](std::uint32_t child, std::uint32_t parent) {
    found = found || (tree.first_child(parent) == child && tree.is_last_child(parent, child));
  });
  return found;
}

template <class Tree>
std::uint64_t visits_of_any(const Tree& a, const Tree& b) {
  const std::uint64_t pairs = std::uint64_t{a.node_count} * b.node_count;
  if (has_single_child(a) || has_single_child(b)) {
    return pairs;
  }
  return std::min(pairs, 2 * std::uint64_t{a.leaf_count} * b.leaf_count - 1);
}

/// The sizes that work depends on.
template <class Tree>
TreeSize size_of(const Tree& tree) {
  std::uint32_t leaf_size = 1;
  for (std::uint32_t leaf = 0; leaf < tree.leaf_count; ++leaf) {
    leaf_size = std::max(leaf_size, tree.triangles_in(leaf));
  }
  return {0, 0, leaf_size, tree.leaf_count, tree.triangle_count};
}

template <class Tree>
VisitBound bound_of(const Tree& a, const Tree& b) {
  const std::uint64_t visits =
      Tree::kLayout == Layout::post_indexed ? ranked_visits(a, b) : visits_of_any(a, b);
  // Each shape takes a visit and has below it at least as many visits as a node has children.
  const std::uint64_t shapes = visits / (has_single_child(a) || has_single_child(b) ? 2 : 3);
  return {visits, std::uint64_t{a.leaf_count} * b.leaf_count,
          std::uint64_t{a.triangle_count} * b.triangle_count,
          most_work(size_of(a), size_of(b), visits, shapes)};
}

}  // namespace

NeededWork needed_work(std::vector<std::uint64_t> work) {
  std::sort(work.begin(), work.end());
  const double sum = std::accumulate(work.begin(), work.end(), 0.0);
  return {work.back(), work[(work.size() * 99 + 99) / 100 - 1],
          sum / static_cast<double>(work.size())};
}

VisitBound visit_bound(const AnyTree& a, const AnyTree& b) {
  return std::visit(
      [&](const auto& tree_a) {
        return bound_of(tree_a, std::get<std::decay_t<decltype(tree_a)>>(b));
      },
      a);
}

}  // namespace flashbvh::tool
