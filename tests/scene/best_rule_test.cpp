// The best rule's dynamic programming against the enumeration of all rules.
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "evaluate/run.hpp"
#include "support/shapes.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using bake::BuildTree;

namespace {

using NodePair = std::pair<std::uint32_t, std::uint32_t>;
/// Of each pair of internal nodes: whether to descend into A.
using Rule = std::map<NodePair, bool>;

bool overlap(const Box& p, const Box& q) {
  return p.upper.x >= q.lower.x && q.upper.x >= p.lower.x && p.upper.y >= q.lower.y &&
         q.upper.y >= p.lower.y && p.upper.z >= q.lower.z && q.upper.z >= p.lower.z;
}

/// By algorithm 2's walk, with this rule.
std::uint64_t visits_of(const BuildTree& a, const BuildTree& b, const Rule& rule) {
  std::vector<NodePair> stack = {{0, 0}};
  std::uint64_t visits = 0;
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    ++visits;
    const auto& node_a = a.nodes[i];
    const auto& node_b = b.nodes[j];
    if (!overlap(node_a.box, node_b.box)) {
      continue;
    }
    if (!node_a.is_leaf() && (node_b.is_leaf() || rule.at({i, j}))) {
      for (const std::uint32_t child : node_a.children) {
        stack.emplace_back(child, j);
      }
    } else {
      for (const std::uint32_t child : node_b.children) {
        stack.emplace_back(i, child);
      }
    }
  }
  return visits;
}

/// All pairs about which a rule has to say something.
std::vector<NodePair> choices(const BuildTree& a, const BuildTree& b) {
  std::vector<NodePair> pairs;
  for (std::uint32_t i = 0; i < a.nodes.size(); ++i) {
    for (std::uint32_t j = 0; j < b.nodes.size(); ++j) {
      if (!a.nodes[i].is_leaf() && !b.nodes[j].is_leaf() &&
          overlap(a.nodes[i].box, b.nodes[j].box)) {
        pairs.emplace_back(i, j);
      }
    }
  }
  return pairs;
}

std::uint64_t fewest_of_all_rules(const BuildTree& a, const BuildTree& b,
                                  const std::vector<NodePair>& pairs) {
  std::uint64_t fewest = UINT64_MAX;
  for (std::uint32_t bits = 0; bits < 1u << pairs.size(); ++bits) {
    Rule rule;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      rule[pairs[i]] = (bits >> i & 1u) != 0;
    }
    fewest = std::min(fewest, visits_of(a, b, rule));
  }
  return fewest;
}

}  // namespace

TEST_CASE("the best rule needs as many visits as the best of all rules, tried one by one") {
  test::Random random(33);
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const auto mesh_a = test::random_mesh(random, 1 + random.below(6), 60, 40);
    const auto mesh_b = test::random_mesh(random, 1 + random.below(6), 60, 40);
    const BuildTree a = test::any_tree(random, mesh_a);
    const BuildTree b = test::any_tree(random, mesh_b);
    const auto pairs = choices(a, b);
    if (pairs.size() <= 10) {
      CHECK(tool::best_rule_visits(a, b, {0, 0, 0}) == fewest_of_all_rules(a, b, pairs));
      compared += pairs.size() >= 2 ? 1 : 0;
    }
  }
  CHECK(compared >= 50);
}

TEST_CASE("the best rule translates B") {
  test::Random random(34);
  const auto mesh = test::random_mesh(random, 40, 300, 100);
  const BuildTree tree = bake::build_median(mesh, 1);
  CHECK(tool::best_rule_visits(tree, tree, {0, 0, 0}) > 1);
  CHECK(tool::best_rule_visits(tree, tree, {2000, 0, 0}) == 1);
  CHECK(tool::best_rule_visits(tree, tree, {0, 0, -2000}) == 1);
}
