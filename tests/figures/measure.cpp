#include "measure.hpp"

#include "insn.hpp"

using namespace flashbvh;

namespace figures {
namespace {

/// From the first visit to the last; `leaf_pair(i, j)` for each pair of leaves whose boxes overlap.
template <class Overlap, class LeafPair>
void walk(const PostTree& a, const PostTree& b, const Overlap& overlap, Budget& budget,
          const LeafPair& leaf_pair) {
  PairCursor<uint16_t> cursor;
  (void)Ranked<PostTree>::run(a, b, overlap, cursor, budget, leaf_pair);
}

/// Calls `run(walk)`, which calls walk(), unless the roots alone tell that the meshes are apart.
/// Returns the visits.
template <class LeafPair, class Run>
uint32_t walk_placed(const PostTree& a, const PostTree& b, Placement& placement,
                     const LeafPair& leaf_pair, const Run& run) {
  if (placement.roots_apart(a, b)) {
    return 1;
  }
  placement.prepare();
  Budget budget = {UINT32_MAX, 0, false};
  if (placement.is_rotated()) {
    RotatedOverlap test(placement.rotated());
    run([&] { walk(a, b, RotatedTest{&test}, budget, leaf_pair); });
  } else {
    run([&] { walk(a, b, placement.translated().overlap, budget, leaf_pair); });
  }
  return UINT32_MAX - budget.visits_left;
}

void place(const PostTree& tree, uint32_t triangle, const Placement& placement,
           PlacedTriangle& placed) {
  if (placement.is_rotated()) {
    place_rotated(tree, triangle, placement.rotated(), placed);
  } else {
    place_translated(tree, triangle, placement.translated().offset, placed);
  }
}

constexpr auto kEveryPair = [](const PairQuery::Pair&) { return true; };

}  // namespace

Walked measure_walk(const PostTree& a, const PostTree& b, const Pose& pose) {
  Placement placement(pose, a, b, /*may_stop=*/true);
  Walked walked{};
  const auto count = [&](uint32_t, uint32_t) {
    ++walked.leaf_pairs;
    return true;
  };
  walked.visits = walk_placed(a, b, placement, count, [&](const auto& all) {
    walked.instructions = port::instructions_of(all);
  });
  return walked;
}

Queried measure_query(const PostTree& a, const PostTree& b, const Pose& pose) {
  Queried queried{};
  queried.instructions = port::instructions_of([&] {
    PairQuery query(a, b, pose);
    queried.status = query.run(UINT32_MAX, kEveryPair);
  });
  queried.until_first = port::instructions_of([&] {
    PairQuery query(a, b, pose);
    (void)query.run(UINT32_MAX, [](const PairQuery::Pair&) { return false; });
  });
  queried.start = port::instructions_of([&] {
    PairQuery query(a, b, pose);
    (void)query.run(1, kEveryPair);
  });
  // Its counts from another run: a user of the first would not copy them.
  PairQuery query(a, b, pose);
  (void)query.run(UINT32_MAX, kEveryPair);
  queried.counts = query.counts();
  return queried;
}

void add_triangle_tests(const PostTree& a, const PostTree& b, const Pose& pose, Spread& tests) {
  Placement placement(pose, a, b, /*may_stop=*/true);
  const auto add = [&](uint32_t i, uint32_t j) {
    const uint32_t leaf_a = a.nodes[i].leaf();
    const uint32_t leaf_b = b.nodes[j].leaf();
    for (uint32_t of_b = b.first_triangle(leaf_b); of_b < b.end_triangle(leaf_b); ++of_b) {
      PlacedTriangle placed_b;
      place(b, of_b, placement, placed_b);
      for (uint32_t of_a = a.first_triangle(leaf_a); of_a < a.end_triangle(leaf_a); ++of_a) {
        PlacedTriangle placed_a;
        place_translated(a, of_a, kNoOffset, placed_a);
        tests.add(port::instructions_of([&] { (void)triangles_intersect(placed_a, placed_b); }));
      }
    }
    return true;
  };
  (void)walk_placed(a, b, placement, add, [](const auto& all) { all(); });
}

void Motion::add(const Walked& walked, const Queried& queried) {
  if (walked.visits <= 1) {
    return;
  }
  visits_ += walked.visits;
  leaf_pairs_ += walked.leaf_pairs;
  walks_ += walked.instructions;
  queries_ += queried.instructions;
  start_.add(queried.start);
  if (walked.visits >= kFewVisits &&
      uint64_t{walked.instructions} * worst_visits_ >= worst_walk_ * walked.visits) {
    worst_walk_ = walked.instructions;
    worst_visits_ = walked.visits;
  }
}

void Motion::print(const char* set, const char* motion) const {
  print_quotient({{set, "visit", motion, "mean"}}, walks_, visits_);
  print_quotient({{set, "visit", motion, "max"}}, worst_walk_, worst_visits_);
  print_figures({{set, "start", motion}}, start_);
  print_quotient({{set, "leaf_pair", motion, "mean"}}, queries_ - walks_ - start_.sum(),
                 leaf_pairs_);
}

}  // namespace figures
