#include "measure.hpp"

#include "flashbvh/detail/predicates/triangle.hpp"
#include "insn.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace figures {
namespace {

/// From the first visit to the last; `leaf_pair(i, j)` for each pair of leaves that may matter.
template <class Bound, class Shapes, class LeafPair>
uint32_t walk(const Bound& bound, Shapes& shapes, LeafPair leaf_pair) {
  PairCursor<uint16_t> cursor;
  WalkRun<PairCursor<uint16_t>, LeafPair> run(cursor, leaf_pair, UINT32_MAX);
  (void)detail::walk<Ranked<PostMesh>>(bound, shapes, run, State::fresh);
  return UINT32_MAX - run.progress.visits_down();
}

/// Calls `run(walk)`, which calls walk(), unless the roots alone tell that the meshes are disjoint.
/// Returns the visits.
template <class Shapes, class LeafPair, class Run>
uint32_t walk_transformed(const PostMesh& a, const PostMesh& b, Transform& transform,
                          const LeafPair& leaf_pair, const Run& run) {
  if (transform.roots_disjoint()) {
    return 1;
  }
  transform.prepare(b);
  uint32_t visits = 0;
  if (transform.is_rotated()) {
    RotatedBound bound(transform.rotated());
    Shapes shapes(a, b, transform);
    shapes.set_bound(bound);
    run([&] { visits = walk(ByReference<RotatedBound>{&bound}, shapes, leaf_pair); });
  } else {
    Shapes shapes(a, b, transform);
    run([&] { visits = walk(transform.translated().bound, shapes, leaf_pair); });
  }
  return visits;
}

/// Leaves whose slabs are made twice, or counted: what that takes more is what they take.
template <bool kCounted>
class MadeTwice : public LeafShapes<PostMesh> {
 public:
  using LeafShapes::LeafShapes;

  static uint32_t slabs;

  bool begin(Side side, uint32_t node, const PackedBox* reached) {
    if (!is_taken(side, node)) {
      (void)LeafShapes::begin(side, node, reached);
      if (kCounted) {
        slabs += made_;
      }
      node_ = nullptr;
    }
    return LeafShapes::begin(side, node, reached);
  }
};
template <bool kCounted>
uint32_t MadeTwice<kCounted>::slabs;

constexpr auto kEveryPair = [](const PairQuery::Pair&) { return true; };

}  // namespace

Walked measure_walk(const PostMesh& a, const PostMesh& b, const Pose& pose) {
  Transform transform(pose, a, b, /*may_stop=*/true);
  Walked walked{};
  const auto count = [&](uint32_t, uint32_t, const Progress&) {
    ++walked.leaf_pairs;
    return true;
  };
  walked.visits = walk_transformed<LeafShapes<PostMesh>>(
      a, b, transform, count,
      [&](const auto& all) { walked.instructions = port::instructions_of(all); });
  walked.inner_visits = walk_transformed<NothingBelow>(
      a, b, transform, count,
      [&](const auto& all) { walked.inner_instructions = port::instructions_of(all); });
  uint32_t again = 0;
  const auto count_again = [&](uint32_t, uint32_t, const Progress&) {
    ++again;
    return true;
  };
  (void)walk_transformed<MadeTwice<false>>(a, b, transform, count_again, [&](const auto& all) {
    walked.slab_instructions = port::instructions_of(all) - walked.instructions;
  });
  MadeTwice<true>::slabs = 0;
  (void)walk_transformed<MadeTwice<true>>(a, b, transform, count_again,
                                          [](const auto& all) { all(); });
  walked.slabs = MadeTwice<true>::slabs;
  return walked;
}

Queried measure_query(const PostMesh& a, const PostMesh& b, const Pose& pose) {
  Queried queried{};
  queried.instructions = port::instructions_of([&] {
    PairQuery query(a, b, pose);
    queried.status = query.run(UINT32_MAX, kEveryPair).status;
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
  constexpr uint32_t kGranted = UINT32_MAX - 1;  // which is a limit
  queried.work = query.run(kGranted, kEveryPair).work;
  queried.counts = query.counts();
  return queried;
}

void add_triangle_tests(const PostMesh& a, const PostMesh& b, const Pose& pose, Spread& tests) {
  Transform transform(pose, a, b, /*may_stop=*/true);
  const auto add = [&](uint32_t i, uint32_t j, const Progress&) {
    const uint32_t leaf_a = a.nodes[i].leaf();
    const uint32_t leaf_b = b.nodes[j].leaf();
    for (uint32_t of_b = b.first_triangle(leaf_b); of_b < b.end_triangle(leaf_b); ++of_b) {
      Triangle triangle_b;
      transform_triangle(b, of_b, transform, triangle_b);
      for (uint32_t of_a = a.first_triangle(leaf_a); of_a < a.end_triangle(leaf_a); ++of_a) {
        Triangle triangle_a;
        translate_triangle(a, of_a, kNoOffset, triangle_a);
        PlaneNormal normal_b;
        get_near_normal(triangle_b, normal_b);
        tests.add(port::instructions_of(
            [&] { (void)near_triangles_intersect(triangle_a, triangle_b, normal_b); }));
      }
    }
    return true;
  };
  (void)walk_transformed<LeafShapes<PostMesh>>(a, b, transform, add,
                                               [](const auto& all) { all(); });
}

void Motion::add(const Walked& walked, const Queried& queried) {
  if (walked.visits <= 1) {
    return;
  }
  visits_ += walked.visits;
  inner_visits_ += walked.inner_visits;
  inner_walks_ += walked.inner_instructions;
  leaf_pairs_ += walked.leaf_pairs;
  walks_ += walked.instructions;
  slabs_ += walked.slabs;
  making_ += walked.slab_instructions;
  queries_ += queried.instructions;
  start_.add(queried.start);
  if (walked.inner_visits >= kFewVisits &&
      uint64_t{walked.inner_instructions} * worst_visits_ >= worst_walk_ * walked.inner_visits) {
    worst_walk_ = walked.inner_instructions;
    worst_visits_ = walked.inner_visits;
  }
}

void Motion::print(const char* set, const char* motion) const {
  print_quotient({{set, "visit", motion, "mean"}}, inner_walks_, inner_visits_);
  print_quotient({{set, "visit", motion, "max"}}, worst_walk_, worst_visits_);
  print_quotient({{set, "leaf_visit", motion, "mean"}}, walks_ - inner_walks_,
                 visits_ - inner_visits_);
  print_quotient({{set, "slab", motion, "mean"}}, making_, slabs_);
  print_quotient({{set, "bare_visit", motion, "mean"}}, walks_ - inner_walks_ - making_,
                 visits_ - inner_visits_);
  print_figures({{set, "start", motion}}, start_);
  print_quotient({{set, "leaf_pair", motion, "mean"}}, queries_ - walks_ - start_.sum(),
                 leaf_pairs_);
}

}  // namespace figures
