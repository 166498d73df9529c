// The model of the proofs in proofs/walk, written independently, against the library's walk.
#include <algorithm>

#include <catch2/catch.hpp>

#include "proofs/walk/generated.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

struct Trees {
  const GeneratedTree& a;
  const GeneratedTree& b;

  bool is_leaf_a(uint32_t i) const { return a.children[i].empty(); }
  bool is_leaf_b(uint32_t j) const { return b.children[j].empty(); }
};

/// Ranked.v: the tree to descend into, and the tree of the last descent.
struct ByRank : Trees {
  using Order = Ranked<ModelTree>;

  static int32_t parent_rank(const GeneratedTree& tree, uint32_t i) {
    return i == 0 ? kRootParentRank : tree.nodes[tree.parent[i]].rank();
  }
  bool descends_b(NodePair p) const { return a.nodes[p.first].rank() < b.nodes[p.second].rank(); }
  bool into_b(NodePair p) const { return parent_rank(b, p.second) <= parent_rank(a, p.first); }
  bool can_visit(NodePair p) const {
    return a.nodes[p.first].rank() < parent_rank(b, p.second) &&
           b.nodes[p.second].rank() <= parent_rank(a, p.first);
  }
};

/// Stackless.v: the paper's rule.
struct ByLevel : Trees {
  using Order = BasicStackless<ModelTree>;

  int lead(NodePair p) const { return int{a.levels[p.first]} - int{b.levels[p.second]}; }
  bool descends_b(NodePair p) const {
    return is_leaf_a(p.first) || (lead(p) >= 0 && !is_leaf_b(p.second));
  }
  bool into_b(NodePair p) const { return lead(p) < 0; }
  bool can_visit(NodePair p) const {
    return (lead(p) <= 0 || is_leaf_b(p.second)) && (lead(p) >= -1 || is_leaf_a(p.first));
  }
};

/// Code.v: a turn, and the tests of a pair, are functions of the pair alone.
template <class Rule>
struct Model : Rule {
  const PairTests& tests;
  using Rule::a, Rule::b, Rule::into_b, Rule::is_leaf_a, Rule::is_leaf_b;
  bool tested(NodePair p) const {
    const bool leaf_a = is_leaf_a(p.first);
    const bool leaf_b = is_leaf_b(p.second);
    if (p != NodePair{0, 0} && (into_b(p) ? leaf_a : leaf_b)) {
      const Side side = into_b(p) ? Side::a : Side::b;
      return tests.touch(side, p.first, p.second) &&
             (!leaf_a || !leaf_b || tests.touch_leaf(side, p.first, p.second));
    }
    return tests.bound(p.first, p.second) && (leaf_a == leaf_b || tests.begin(p.first, p.second));
  }
  bool found(NodePair p) const { return tested(p) && is_leaf_a(p.first) && is_leaf_b(p.second); }

  /// The recursive search.
  void search(NodePair p, Walked& walked) const {
    walked.visits.push_back(p);
    if (!tested(p)) {
      return;
    }
    if (found(p)) {
      walked.found.push_back(p);
    }
    if (this->descends_b(p)) {
      for (const uint32_t child : b.children[p.second]) {
        search({p.first, child}, walked);
      }
    } else {
      for (const uint32_t child : a.children[p.first]) {
        search({child, p.second}, walked);
      }
    }
  }

  /// The rest of the walk from a pair, or from behind it: the loop, by parents and children.
  Walked rest(NodePair p, bool visit) const {
    Walked walked;
    for (;;) {
      if (visit) {
        search(p, walked);
      }
      const bool in_b = into_b(p);
      const GeneratedTree& tree = in_b ? b : a;
      uint32_t& node = in_b ? p.second : p.first;
      if (node == 0) {
        return walked;
      }
      const auto& siblings = tree.children[tree.parent[node]];
      const auto here = std::find(siblings.begin(), siblings.end(), node);
      visit = here + 1 != siblings.end();
      node = visit ? here[1] : tree.parent[node];
    }
  }
};

template <class Rule>
struct Subject {
  GeneratedTree a, b;
  PairTests tests;
  Model<Rule> model{{{a, b}}, tests};

  explicit Subject(Random& random)
      : a(GeneratedTree::random(random)),
        b(GeneratedTree::random(random)),
        tests{2 + random.below(30)} {}
  Subject(const Subject&) = delete;

  /// The library's walk from a cursor to its end, cut by random work and batches.
  Walked walked_from(Random& random, PairCursor<uint16_t> cursor, State state) const {
    Walked walked;
    const ModelTree tree_a = a.view();
    const ModelTree tree_b = b.view();
    const uint32_t most = random.below(3) == 0 ? 1000 : 1 + random.below(12);
    while (state != State::done) {
      const uint32_t work = 1 + random.below(most);
      walk_on<typename Rule::Order>(tree_a, tree_b, tests, work, 1 + random.below(4), cursor, state,
                                    walked);
      if (state != State::done) {
        REQUIRE(model.can_visit({cursor.a, cursor.b}));
      }
    }
    return walked;
  }
};

}  // namespace

TEMPLATE_TEST_CASE("the walk that is proved is the library's, however it is cut", "", ByRank,
                   ByLevel) {
  const uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed);
  size_t visits = 0;
  for (int round = 0; round < 2000; ++round) {
    CAPTURE(round);
    const Subject<TestType> subject(random);
    Walked expected;
    subject.model.search({0, 0}, expected);
    REQUIRE(subject.walked_from(random, {}, State::fresh) == expected);
    visits += expected.visits.size();
  }
  REQUIRE(visits > 20'000);
}

TEMPLATE_TEST_CASE("what is proved of a position is so of each that the library accepts", "",
                   ByRank, ByLevel) {
  const uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 1);
  int accepted = 0;
  for (int round = 0; round < 4000; ++round) {
    CAPTURE(round);
    const Subject<TestType> subject(random);
    const auto a =
        static_cast<uint16_t>(random.below(static_cast<uint32_t>(subject.a.nodes.size())));
    const auto b =
        static_cast<uint16_t>(random.below(static_cast<uint32_t>(subject.b.nodes.size())));
    CAPTURE(a, b);
    const bool possible = subject.model.can_visit({a, b});
    using Order = typename TestType::Order;
    REQUIRE(Order::can_visit(subject.a.view(), subject.b.view(), {a, b}) == possible);
    // No walk stops before the visit of the roots: this is `fresh`.
    const bool visit = random.below(2) != 0 && (a != 0 || b != 0);
    if (possible) {
      ++accepted;
      REQUIRE(subject.walked_from(random, {a, b}, visit ? State::at_pair : State::at_leaf_pair) ==
              subject.model.rest({a, b}, visit));
    }
  }
  REQUIRE(accepted > 1000);
}
