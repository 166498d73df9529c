// Runs a traversal and records the pairs that it visits.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "flashbvh/detail/bounds/box.hpp"
#include "support/at_roots.hpp"
#include "support/points.hpp"
#include "support/shapes.hpp"
#include "support/walk.hpp"

namespace flashbvh::test {

/// Two nodes, by their indices in the BuildTrees, which do not depend on the layout.
using NodePair = std::pair<std::uint32_t, std::uint32_t>;
using NodePairs = std::vector<NodePair>;

inline NodePairs sorted(NodePairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

struct Record {
  NodePairs visits;
  NodePairs leaf_pairs;
  std::uint32_t overlaps = 0;
  bool ended = false;
};

/// A pair of trees in one layout.
template <class Baked>
struct BakedPair {
  Baked a;
  Baked b;

  NodePair build_pair(std::uint32_t node_a, std::uint32_t node_b) const {
    return {a.build_nodes[node_a], b.build_nodes[node_b]};
  }
};

template <Layout layout>
BakedPair<Baked<layout>> bake_pair(const bake::BuildTree& a, const bake::LatticeMesh& mesh_a,
                                   const bake::BuildTree& b, const bake::LatticeMesh& mesh_b) {
  return {baked<layout>(a, mesh_a), baked<layout>(b, mesh_b)};
}

/// An overlap test that identifies the tested nodes by their boxes' addresses.
template <class Baked>
class RecordingOverlap {
 public:
  RecordingOverlap(const BakedPair<Baked>& pair, const detail::TranslatedBoxTest& test,
                   Record& record)
      : pair_(pair), test_(test), record_(record) {}

  bool operator()(const PackedBox& box_a, const PackedBox& box_b) const {
    record_.visits.push_back(pair_.build_pair(index_in(pair_.a, box_a), index_in(pair_.b, box_b)));
    return test_(box_a, box_b);
  }

 private:
  static std::uint32_t index_in(const Baked& baked, const PackedBox& box) {
    using NodeType = Node<typename Baked::Index>;
    const auto* const node = reinterpret_cast<const NodeType*>(&box);
    return static_cast<std::uint32_t>(node - baked.nodes.data());
  }

  const BakedPair<Baked>& pair_;
  const detail::TranslatedBoxTest& test_;
  Record& record_;
};

/// Records a walk from `cursor` to the end, or to `most_visits` if the walk does not end.
template <class Traversal, class Baked>
Record record_from(const BakedPair<Baked>& pair, const detail::TranslatedBoxTest& test,
                   typename Traversal::Cursor& cursor, std::uint32_t most_visits = 1000000) {
  Record record;
  const auto a = pair.a.view();
  const auto b = pair.b.view();
  const auto leaf_pair = [&](std::uint32_t node_a, std::uint32_t node_b, const detail::Progress&) {
    record.leaf_pairs.push_back(pair.build_pair(node_a, node_b));
    return true;
  };
  const Walked walked = walk_from<Traversal>(a, b, RecordingOverlap<Baked>(pair, test, record),
                                             cursor, leaf_pair, most_visits);
  record.overlaps = walked.counts.overlaps;
  record.ended = walked.end == detail::State::done;
  return record;
}

/// Records a whole walk; a stack gets exactly stack_entries() entries.
template <class Traversal, class Baked>
Record record(const BakedPair<Baked>& pair, const detail::TranslatedBoxTest& test) {
  std::vector<detail::PairCursor<typename Baked::Index>> entries(
      stack_entries(pair.a.stack_need, pair.b.stack_need));
  auto cursor = at_roots<Traversal>(entries.data(), static_cast<std::uint32_t>(entries.size()));
  return record_from<Traversal>(pair, test, cursor);
}

/// All pairs of leaves whose boxes overlap, in order.
inline NodePairs brute_force(const bake::BuildTree& a, const bake::BuildTree& b,
                             const Point& translation) {
  NodePairs pairs;
  for (std::uint32_t i = 0; i < a.nodes.size(); ++i) {
    for (std::uint32_t j = 0; j < b.nodes.size(); ++j) {
      if (a.nodes[i].is_leaf() && b.nodes[j].is_leaf() &&
          overlap(a.nodes[i].box, b.nodes[j].box, translation)) {
        pairs.emplace_back(i, j);
      }
    }
  }
  return pairs;
}

}  // namespace flashbvh::test
