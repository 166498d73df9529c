// Properties 6.1 to 6.7 of algorithm 3, on stacks recorded before and after each iteration.
//
// The properties apply to full binary trees of equal height.
#include <map>

#include "support/record.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

using Stack = NodePairs;  // bottom first; array positions

/// One iteration of algorithm 3.
struct Iteration {
  NodePair popped;
  Stack below;  ///< the stack after the pop
  Stack after;  ///< the stack at the iteration's end
};

struct Run {
  BakedPair<Baked<Layout::pre_indexed>> trees;
  std::vector<Iteration> iterations;
};

Stack copy_of(const PairStack<std::uint16_t>& stack) {
  Stack copy;
  for (std::uint32_t i = 0; i < stack.size(); ++i) {
    copy.emplace_back(stack.entries()[i].a, stack.entries()[i].b);
  }
  return copy;
}

/// Runs the library's traversal one visit at a time and records its stack.
Run run(Random random, std::uint32_t depth) {
  const auto mesh_a = random_mesh(random, 1u << depth, 40, 20);
  const auto mesh_b = random_mesh(random, 1u << depth, 40, 20);
  Run run{bake_pair<Layout::pre_indexed>(full_tree(mesh_a, depth), mesh_a, full_tree(mesh_b, depth),
                                         mesh_b),
          {}};
  const auto a = run.trees.a.view();
  const auto b = run.trees.b.view();
  std::vector<PairCursor<std::uint16_t>> entries(stack_entries(a.stack_need, b.stack_need));
  PairStack<std::uint16_t> stack(entries.data(), static_cast<std::uint32_t>(entries.size()));
  while (stack.size() != 0) {
    Stack before = copy_of(stack);
    (void)walk_from<AlternatingStack>(
        a, b, TranslatedBoxTest(3, -5, 8), stack,
        [](std::uint32_t, std::uint32_t, const Progress&) { return true; }, 1);
    const NodePair popped = before.back();
    before.pop_back();
    run.iterations.push_back({popped, before, copy_of(stack)});
  }
  return run;
}

template <class Check>
void for_runs(Check check) {
  for (std::uint32_t depth = 0; depth <= 5; ++depth) {
    for (std::uint64_t round = 0; round < 5; ++round) {
      check(run(test_random(round), depth));
    }
  }
}

std::uint32_t level_a(const Run& run, const NodePair& e) {
  return run.trees.a.levels[e.first];
}
std::uint32_t level_b(const Run& run, const NodePair& e) {
  return run.trees.b.levels[e.second];
}

bool is_left(const Baked<Layout::pre_indexed>& tree, std::uint32_t node) {
  return tree.view().rcl(node) == 0;
}

/// If B's level is `levels` below A's and `is_kind(A is a left child, B is one)`, popping a pair
/// leaves the stack below the pair in which A, B or both are replaced by their parents.
template <class IsKind>
void check_stack_of_parent(std::uint32_t levels, IsKind is_kind, bool up_a, bool up_b) {
  for_runs([&](const Run& run) {
    std::map<NodePair, Stack> below;  // at the pop of each element, which happens once
    for (const Iteration& iteration : run.iterations) {
      below[iteration.popped] = iteration.below;
    }
    for (const auto& [e, stack] : below) {
      if (level_a(run, e) + levels == level_b(run, e) &&
          is_kind(is_left(run.trees.a, e.first), is_left(run.trees.b, e.second))) {
        REQUIRE(stack == below.at({up_a ? run.trees.a.climb[e.first] : e.first,
                                   up_b ? run.trees.b.climb[e.second] : e.second}));
      }
    }
  });
}

}  // namespace

TEST_CASE("property 6.1: level(A) = level(B) or level(A) = level(B) - 1") {
  for_runs([](const Run& run) {
    for (const Iteration& iteration : run.iterations) {
      for (const NodePair& e : iteration.after) {
        const std::uint32_t a = level_a(run, e);
        const std::uint32_t b = level_b(run, e);
        REQUIRE((a == b || a + 1 == b));
      }
    }
  });
}

TEST_CASE("property 6.2: elements are added two at a time, the right child's below the left's") {
  for_runs([](const Run& run) {
    for (const Iteration& iteration : run.iterations) {
      const std::size_t added = iteration.after.size() - iteration.below.size();
      REQUIRE((added == 0 || added == 2));
      REQUIRE(std::equal(iteration.below.begin(), iteration.below.end(), iteration.after.begin()));
      if (added == 2) {
        const NodePair upper = iteration.after.back();
        const NodePair lower = iteration.after[iteration.after.size() - 2];
        const auto [a, b] = iteration.popped;
        if (level_a(run, iteration.popped) == level_b(run, iteration.popped)) {
          REQUIRE(upper == NodePair(a, b + 1));
          REQUIRE(lower == NodePair(a, run.trees.b.view().escape(b + 1)));
        } else {
          REQUIRE(upper == NodePair(a + 1, b));
          REQUIRE(lower == NodePair(run.trees.a.view().escape(a + 1), b));
        }
      }
    }
  });
}

TEST_CASE("property 6.3: when the stack is empty, all collisions have been found") {
  for_runs([](const Run& run) {
    REQUIRE(run.iterations.back().after.empty());
    NodePairs visited;
    for (const Iteration& iteration : run.iterations) {
      visited.push_back(iteration.popped);
    }
    std::sort(visited.begin(), visited.end());
    REQUIRE(std::adjacent_find(visited.begin(), visited.end()) == visited.end());
    const TranslatedBoxTest overlap(3, -5, 8);
    for (std::uint32_t i = 0; i < run.trees.a.nodes.size(); ++i) {
      for (std::uint32_t j = 0; j < run.trees.b.nodes.size(); ++j) {
        const auto& a = run.trees.a.nodes[i];
        const auto& b = run.trees.b.nodes[j];
        if (a.is_leaf() && b.is_leaf() && overlap(a.box, b.box)) {
          REQUIRE(std::binary_search(visited.begin(), visited.end(), NodePair(i, j)));
        }
      }
    }
  });
}

TEST_CASE("property 6.4: between e and the element below it, only pairs below e are popped") {
  for_runs([](const Run& run) {
    for (std::size_t i = 0; i < run.iterations.size(); ++i) {
      const Iteration& e = run.iterations[i];
      std::size_t k = i + 1;
      const auto end_a = run.trees.a.view().escape(e.popped.first);
      const auto end_b = run.trees.b.view().escape(e.popped.second);
      while (k < run.iterations.size() && run.iterations[k].below.size() >= e.below.size()) {
        const NodePair inner = run.iterations[k].popped;
        REQUIRE((inner.first >= e.popped.first && inner.first < end_a));
        REQUIRE((inner.second >= e.popped.second && inner.second < end_b));
        ++k;
      }
      if (!e.below.empty()) {
        REQUIRE(k < run.iterations.size());
        REQUIRE(run.iterations[k].popped == e.below.back());
      }
    }
  });
}

TEST_CASE("property 6.5: popping (A, Br), A a level above Br, leaves the stack of (A, B)") {
  check_stack_of_parent(
      1, [](bool, bool left_b) { return !left_b; }, false, true);
}

TEST_CASE("property 6.6: popping (Ar, Bl) of the same level leaves the stack of (A, Bl)") {
  check_stack_of_parent(
      0, [](bool left_a, bool left_b) { return !left_a && left_b; }, true, false);
}

TEST_CASE("property 6.7: popping (Ar, Br) of the same level leaves the stack of (A, B)") {
  check_stack_of_parent(
      0, [](bool left_a, bool left_b) { return !left_a && !left_b; }, true, true);
}
