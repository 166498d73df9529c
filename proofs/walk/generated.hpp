// Random post-indexed trees, and the results of the library's walks on them. Pairs are tested by
// functions of their indices, so that a model can answer without a box.
#pragma once

#include <utility>
#include <vector>

#include "flashbvh/detail/walk/walk.hpp"
#include "flashbvh/traversal/ranked.hpp"
#include "flashbvh/traversal/stackless.hpp"
#include "support/random.hpp"

namespace flashbvh::test {

using ModelTree = MeshWithLevels;
using ModelNode = Node<uint16_t>;
using NodePair = std::pair<uint32_t, uint32_t>;

/// A tree by its links and ranks, and by the intended children and levels.
struct GeneratedTree {
  std::vector<ModelNode> nodes;
  std::vector<std::vector<uint32_t>> children;
  std::vector<uint32_t> parent;  ///< 0 of the root
  std::vector<uint16_t> levels;
  std::vector<uint16_t> right_child_levels;

  ModelTree view() const {
    ModelTree tree = {};
    tree.nodes = nodes.data();
    tree.node_count = static_cast<uint16_t>(nodes.size());
    tree.levels = levels.data();
    tree.right_child_levels = right_child_levels.data();
    return tree;
  }

  static GeneratedTree random(Random& random) {
    constexpr uint32_t limits[] = {2, 4, kMaxRank};
    GeneratedTree tree;
    const uint32_t limit = random.one_of(limits);
    tree.grow(random, limit, kRootParentRank, random.below(5), 0);
    tree.nodes[0].link = static_cast<uint16_t>(tree.nodes.size());
    tree.set_levels();
    return tree;
  }

 private:
  /// Appends a node, and its children from the last one to the first.
  void grow(Random& random, uint32_t limit, uint32_t parent_rank, uint32_t depth, uint32_t above) {
    const auto self = static_cast<uint32_t>(nodes.size());
    ModelNode node = {};
    node.box.z = self;  // identifies the node in a box test
    node.link = static_cast<uint16_t>(self);
    node.data = static_cast<uint16_t>(ModelNode::kLeafFlag | random.below(300));
    nodes.push_back(node);
    children.emplace_back();
    parent.push_back(above);
    if (depth == 0 || random.below(6) == 0) {
      return;
    }
    const uint32_t rank = 1 + random.below(limit);
    nodes[self].data = static_cast<uint16_t>(rank << 8 | parent_rank);
    uint32_t later = self;
    for (uint32_t i = 1 + random.below(3); i > 0; --i) {
      const auto child = static_cast<uint32_t>(nodes.size());
      grow(random, rank, rank, depth - 1, self);
      if (later != self) {
        nodes[child].link = static_cast<uint16_t>(later);
      }
      children[self].insert(children[self].begin(), child);
      later = child;
    }
    nodes[self + 1].link = static_cast<uint16_t>(later);
  }

  void set_levels() {
    levels.assign(nodes.size(), 0);
    right_child_levels.assign(nodes.size(), 0);
    for (uint32_t i = 1; i < nodes.size(); ++i) {
      const uint32_t above = parent[i];
      levels[i] = static_cast<uint16_t>(levels[above] + 1);
      const bool last = children[above].back() == i;
      right_child_levels[i] = static_cast<uint16_t>(last ? right_child_levels[above] + 1 : 0);
    }
  }
};

/// The tests of a pair: bound, begin and touch of Code.v. For two leaves, touch stands for both
/// touch() and touch_leaf().
struct PairTests {
  uint32_t modulus;  ///< at least 2; a larger one passes more pairs

  /// The roots always pass, so that a walk gets beyond them.
  bool bound(uint32_t a, uint32_t b) const { return (a * 7 + b * 11 + a * b + 1) % modulus != 0; }
  bool begin(uint32_t a, uint32_t b) const { return (a * 5 + b * 3) % modulus != 1; }
  bool touch(detail::Side side, uint32_t a, uint32_t b) const {
    return (a * 3 + b * 13 + (side == detail::Side::a ? 1 : 2)) % modulus != 0;
  }
  bool touch_leaf(detail::Side side, uint32_t a, uint32_t b) const {
    return (a * 17 + b * 5 + (side == detail::Side::a ? 1 : 2)) % modulus != 1;
  }
};

/// The results of walks: visits, and the visits that found pairs of leaves.
struct Walked {
  std::vector<NodePair> visits;
  std::vector<NodePair> found;

  bool operator==(const Walked& other) const {
    return visits == other.visits && found == other.found;
  }
};

/// Leaf planes that call PairTests.
class TestedShapes {
 public:
  using Tree = ModelTree;
  static constexpr bool kShapes = true;
  static constexpr bool kKnowsRoot = true;
  static constexpr bool kComparesLeaves = true;

  TestedShapes(const Tree& tree_a, const Tree& tree_b, const PairTests& tests, Walked& walked)
      : a(tree_a), b(tree_b), tests_(tests), walked_(walked) {}

  uint32_t work_of(detail::Side, uint32_t node) const { return node % 3; }
  bool is_taken(detail::Side side, uint32_t node) const { return side == side_ && node == node_; }
  void take_again(detail::Side side, uint32_t node) {
    side_ = side;
    node_ = node;
  }
  bool begin(detail::Side side, uint32_t node, const PackedBox* reached) {
    take_again(side, node);
    return reached == nullptr || (side == detail::Side::a ? tests_.begin(node, reached->z)
                                                          : tests_.begin(reached->z, node));
  }
  bool may_touch(const PackedBox& box) const {
    const NodePair pair = pair_with(box.z);
    walked_.visits.push_back(pair);
    return tests_.touch(side_, pair.first, pair.second);
  }
  bool rejects_leaf(uint32_t node, detail::Progress& progress) const {
    const NodePair pair = pair_with(node);
    if (tests_.touch_leaf(side_, pair.first, pair.second)) {
      return false;
    }
    progress.spend(node % 4);
    return true;
  }
  void keep_root(uint32_t root) { root_ = root; }
  uint32_t kept_root() const { return root_; }
  detail::Side leaf_side() const { return side_; }

  const Tree& a;
  const Tree& b;

 private:
  NodePair pair_with(uint32_t node) const {
    return side_ == detail::Side::a ? NodePair{node_, node} : NodePair{node, node_};
  }

  const PairTests& tests_;
  Walked& walked_;
  detail::Side side_ = detail::Side::none;
  uint32_t node_ = 0;
  uint32_t root_ = 0;
};

/// Runs the library's walk once with `work` from a cursor, which it advances. It stops after
/// `batch` pairs of leaves or, if `to_end`, continues from there.
template <class Traversal>
void walk_on(const ModelTree& a, const ModelTree& b, const PairTests& tests, uint32_t work,
             uint32_t batch, detail::PairCursor<uint16_t>& cursor, detail::State& state,
             Walked& walked, bool to_end = false) {
  const auto bound = [&](const PackedBox& box_a, const PackedBox& box_b) {
    walked.visits.emplace_back(box_a.z, box_b.z);
    return tests.bound(box_a.z, box_b.z);
  };
  uint32_t left = batch;
  auto leaf_pair = [&](uint32_t i, uint32_t j, detail::Progress&) {
    walked.found.emplace_back(i, j);
    return --left != 0;
  };
  TestedShapes shapes(a, b, tests, walked);
  do {
    left = batch;
    detail::WalkRun<detail::PairCursor<uint16_t>, decltype(leaf_pair)> run(cursor, leaf_pair, work);
    state = detail::walk<Traversal>(bound, shapes, run, state);
  } while (to_end && state != detail::State::done);
}

}  // namespace flashbvh::test
