// Instructions per visit of the box traversals, counted on the target, against their budgets.
//
// Two tori of 800 triangles, translation only, the paper's median-split trees: one setup each where
// they intersect deeply, just touch, and are separated.
#include <catch2/catch.hpp>

#include <cstdio>
#include <vector>

#include "bake/baked_tree.hpp"
#include "flashbvh/traversal/alternating_stack.hpp"
#include "flashbvh/traversal/leaf.hpp"
#include "flashbvh/traversal/ranked.hpp"
#include "flashbvh/traversal/ranked_stack.hpp"
#include "flashbvh/traversal/stackless.hpp"
#include "flashbvh/traversal/stackless_post.hpp"
#include "flashbvh/traversal/volume_stack.hpp"
#include "insn.hpp"
#include "support/torus.hpp"

using namespace flashbvh;

namespace {

struct Setup {
  const char* name;
  TranslatedOverlap overlap;
};

const Setup kSetups[] = {{"intersecting", {3000, 1000, 500}},
                         {"touching", {7950, 300, 100}},
                         {"separated", {30000, 0, 0}}};

template <Layout layout>
bake::BakedTree<std::uint16_t, layout> baked_torus() {
  const bake::LatticeMesh mesh = test::torus(20, 20, 6000, 2000);
  return bake::lay_out<std::uint16_t, layout>(bake::build_median(mesh, 1), mesh);
}

struct Measured {
  std::uint32_t visits;
  std::uint32_t leaf_pairs;
  std::uint32_t instructions;
};

template <class Traversal, class Tree, class Cursor>
Measured measure(const Tree& a, const Tree& b, const TranslatedOverlap& overlap, Cursor& cursor) {
  Measured measured{};
  measured.instructions = port::instructions_of([&] {
    Budget budget = {1000000, 0, false};
    std::uint32_t leaf_pairs = 0;
    (void)Traversal::run(a, b, overlap, cursor, budget, [&](std::uint32_t, std::uint32_t) {
      ++leaf_pairs;
      return true;
    });
    measured.visits = 1000000 - budget.visits_left;
    measured.leaf_pairs = leaf_pairs;
  });
  return measured;
}

template <class Traversal>
struct Run {
  template <class Tree>
  static Measured on(const Tree& a, const Tree& b, const TranslatedOverlap& overlap) {
    typename Traversal::Cursor cursor;
    return measure<Traversal>(a, b, overlap, cursor);
  }
};

template <class TreeType, class Rule>
struct Run<StackWalk<TreeType, Rule>> {
  static Measured on(const TreeType& a, const TreeType& b, const TranslatedOverlap& overlap) {
    std::vector<PairCursor<std::uint16_t>> entries(stack_entries(a.stack_need, b.stack_need));
    PairStack<std::uint16_t> cursor(entries.data(), static_cast<std::uint32_t>(entries.size()));
    return measure<StackWalk<TreeType, Rule>>(a, b, overlap, cursor);
  }
};

/// Prints a line a setup; returns instructions per visit in tenths over the first two.
template <class Traversal>
std::uint32_t report(const char* name) {
  const auto baked_a = baked_torus<Traversal::Tree::kLayout>();
  const auto baked_b = baked_torus<Traversal::Tree::kLayout>();
  const auto a = baked_a.view();
  const auto b = baked_b.view();
  std::uint32_t visits = 0;
  std::uint32_t instructions = 0;
  for (const Setup& setup : kSetups) {
    const Measured run = Run<Traversal>::on(a, b, setup.overlap);
    std::printf("%-18s %-13s %6u visits %5u leaf pairs %8u instructions %4u.%u per visit\n", name,
                setup.name, static_cast<unsigned>(run.visits),
                static_cast<unsigned>(run.leaf_pairs), static_cast<unsigned>(run.instructions),
                static_cast<unsigned>(run.instructions / run.visits),
                static_cast<unsigned>(run.instructions * 10 / run.visits % 10));
    if (run.visits > 10) {
      visits += run.visits;
      instructions += run.instructions;
    }
  }
  return instructions * 10 / visits;
}

/// A budget in tenths of an instruction per visit on this core; 0 where there is none.
struct VisitBudget {
  std::uint32_t stackless_post;
  std::uint32_t ranked;
};

#if defined(__ARM_FEATURE_SIMD32)
constexpr VisitBudget kBudget = {450, 360};
#else
constexpr VisitBudget kBudget = {0, 480};
#endif

}  // namespace

TEST_CASE("instructions per visit stay within their budgets") {
  (void)report<VolumeStack<PostTree>>("volume-stack");
  (void)report<AlternatingStack<LevelledPostTree>>("alternating-stack");
  (void)report<Stackless>("stackless");
  const std::uint32_t stackless_post = report<StacklessPost>("stackless-post");
  (void)report<Leaf<PostTree>>("leaf");
  const std::uint32_t ranked = report<Ranked<PostTree>>("ranked");
  (void)report<RankedStack<PostTree>>("ranked-stack");
  std::fflush(stdout);
  CHECK((kBudget.stackless_post == 0 || stackless_post <= kBudget.stackless_post));
  CHECK(ranked <= kBudget.ranked);
}
