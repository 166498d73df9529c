#include "measure.hpp"

#include "insn.hpp"
#include "flashbvh/detail/triangle.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace figures {
namespace {

/// From the first visit to the last, unless the roots alone tell that the meshes are disjoint;
/// `leaf_pair(i, j, progress)` for each pair of leaves that may matter. Returns the visits. Without
/// `kBelow` nothing below a leaf is visited: what is left are the pairs of nodes that are no
/// leaves, and the first pairs with one.
template <bool kBelow, class LeafPair>
uint32_t walk(const PostMesh& a, const PostMesh& b, const Transform& transform,
              LeafPair leaf_pair) {
  using Order = Ranked<PostMesh>;
  PairCursor<uint16_t> cursor;
  WalkRun<PairCursor<uint16_t>, LeafPair> run = {&cursor, &leaf_pair, {UINT32_MAX, 0}};
  RotatedBound bound(transform.rotated());  // not asked under a translation
  const auto pairs = [&](State from) {
    if (transform.is_rotated()) {
      return detail::walk<Order, true>(a, b, ByReference<RotatedBound>{&bound}, run, from);
    }
    return detail::walk<Order, true>(a, b, transform.translated().bound, run, from);
  };
  (void)walk_with_shapes<Order>(run, State::fresh, pairs, [&](State from) {
    if (kBelow) {
      LeafShapes<PostMesh> shapes(a, b, transform, transform.is_rotated() ? &bound : nullptr);
      return walk_below_leaf<Order>(shapes, run, from);
    }
    Order at(a, b, cursor);
    const bool more = at.next();
    at.store(cursor, !more);
    return more ? State::at_pair : State::done;
  });
  return UINT32_MAX - run.progress.visits_left;
}

/// Prepares the transform and calls `run(walk)`, unless the roots alone tell that the meshes are
/// disjoint.
template <class Run>
void unless_disjoint(const PostMesh& a, const PostMesh& b, Transform& transform, const Run& run) {
  if (!transform.roots_disjoint(a, b)) {
    transform.prepare(b.nodes[0].box);
    run();
  }
}

constexpr auto kEveryPair = [](const PairQuery::Pair&) { return true; };

}  // namespace

Walked measure_walk(const PostMesh& a, const PostMesh& b, const Pose& pose) {
  Transform transform(pose, a, b, /*may_stop=*/true);
  Walked walked = {1, 0, 0, 0, 0};
  const auto none = [](uint32_t, uint32_t, const Progress&) { return true; };
  const auto count = [&](uint32_t, uint32_t, const Progress&) {
    ++walked.leaf_pairs;
    return true;
  };
  unless_disjoint(a, b, transform, [&] {
    walked.instructions =
        port::instructions_of([&] { walked.visits = walk<true>(a, b, transform, count); });
    walked.inner_instructions =
        port::instructions_of([&] { walked.inner_visits = walk<false>(a, b, transform, none); });
  });
  return walked;
}

Queried measure_query(const PostMesh& a, const PostMesh& b, const Pose& pose) {
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

void add_triangle_tests(const PostMesh& a, const PostMesh& b, const Pose& pose, Spread& tests) {
  Transform transform(pose, a, b, /*may_stop=*/true);
  const auto add = [&](uint32_t i, uint32_t j, const Progress&) {
    const uint32_t leaf_a = a.nodes[i].leaf();
    const uint32_t leaf_b = b.nodes[j].leaf();
    for (uint32_t of_b = b.first_triangle(leaf_b); of_b < b.end_triangle(leaf_b); ++of_b) {
      Triangle triangle_b;
      transform_triangle(b, of_b, transform, triangle_b);
      for (uint32_t of_a = a.first_triangle(leaf_a); of_a < a.end_triangle(leaf_a); ++of_a) {
        const auto& corner = a.triangles[of_a].corner;
        tests.add(port::instructions_of([&] {
          const Point(&p)[3] = triangle_b.corner;
          (void)near_triangles_intersect(
              {{a.vertices + corner[0], a.vertices + corner[1], a.vertices + corner[2]}},
              triangle_b, Plane(p[0], p[1], p[2]));
        }));
      }
    }
    return true;
  };
  unless_disjoint(a, b, transform, [&] { (void)walk<true>(a, b, transform, add); });
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
  print_figures({{set, "start", motion}}, start_);
  print_quotient({{set, "leaf_pair", motion, "mean"}}, queries_ - walks_ - start_.sum(),
                 leaf_pairs_);
}

}  // namespace figures
