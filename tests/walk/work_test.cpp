// Runs cut by work: pairs, their order and counts do not change, and each run spends its budget and
// at most a step more.
#include "flashbvh/image.hpp"
#include "flashbvh/time_bound.hpp"
#include "support/any_mesh.hpp"
#include "support/most_work.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

/// Stops once at each pair and goes on.
template <class Traversal>
std::uint32_t check_counts(const typename Traversal::Tree& a, const typename Traversal::Tree& b,
                           const Pose& pose) {
  Pairs pairs;
  std::vector<QueryStats> counts;
  AnyQuery<Traversal> whole(a, b, pose);
  auto& query = whole.query;
  const auto add = [&](const auto& pair) {
    pairs.emplace_back(pair.a, pair.b);
    counts.push_back(query.stats());
    return true;
  };
  REQUIRE(query.run(kNoLimit, add).status == Status::done);
  for (std::size_t stop = 0; stop < pairs.size(); stop += 1 + stop / 8) {
    CAPTURE(stop);
    REQUIRE(counts[stop].triangle_pairs == stop + 1);
    AnyQuery<Traversal> cut(a, b, pose);
    std::size_t found = 0;
    REQUIRE(cut.query.run(kNoLimit, [&](const auto&) { return found++ != stop; }).status ==
            Status::full);
    REQUIRE(same(cut.query.stats(), counts[stop]));
    const Pairs rest(pairs.begin() + static_cast<std::ptrdiff_t>(stop) + 1, pairs.end());
    REQUIRE(run_to_end(cut.query) == rest);
    REQUIRE(same(cut.query.stats(), query.stats()));
  }
  return static_cast<std::uint32_t>(pairs.size());
}

}  // namespace

TEST_CASE("counts inside a sink are those of a query that is stopped there") {
  std::uint32_t pairs = 0;
  for_rounds(40, 5, [&](Random& random, int) {
    const Scene scene = any_scene(random);
    for_each_order<std::uint16_t>([&](auto named) {
      using Traversal = typename decltype(named)::Traversal;
      CAPTURE(named.name, static_cast<int>(Traversal::Tree::kLayout));
      using Tree = typename Traversal::Tree;
      pairs += check_counts<Traversal>(scene.a.view<Tree>(), scene.b.view<Tree>(), scene.pose);
    });
  });
  CHECK(pairs > 1000);
}

TEST_CASE("counts stay right over more work than one batch may take") {
  Random random = test_random(7);
  // Triangles in random order: nearly all boxes but the leaves' overlap.
  const auto mesh_a = random_mesh(random, 400, 3000, 40);
  const auto mesh_b = random_mesh(random, 400, 3000, 40);
  const AnyMesh a(random_tree(random, mesh_a, {2, 1, false}), mesh_a);
  const AnyMesh b(random_tree(random, mesh_b, {2, 1, false}), mesh_b);
  const Pose pose = Pose::translated(20, 30, 0);
  PairQuery whole(a, b, pose);
  const Pairs expected = run_to_end(whole);
  for (const std::uint32_t work : {9999u, 65535u, 65536u, 131071u}) {
    PairQuery cut(a, b, pose);
    REQUIRE(run_to_end(cut, work, 100) == expected);
    REQUIRE(same(cut.stats(), whole.stats()));
  }
  CHECK(whole.stats().visits > 65536);
  // Each overlapping pair, except pairs of leaves, has two below it. Planes of leaves reject some.
  Query<Ranked<Mesh>, BoxIntersection> boxes(a, b, pose);
  run_to_end(boxes);
  CHECK(boxes.stats().visits == 1 + 2 * (boxes.stats().overlaps - boxes.stats().leaf_pairs));
}

namespace {

/// Triangle tests that are counted.
struct CountedTests : Intersection {
  static constexpr bool kIntersects = false;
  std::uint32_t* tests = nullptr;

  bool test(const Triangle& a, const Triangle& b, std::uint32_t, std::uint32_t) const {
    ++*tests;
    return triangles_intersect(a, b);
  }
};

/// Whether a query in one run can have spent this work, if its leaves have one to `most` triangles.
bool is_work_of(const QueryStats& counts, std::uint32_t work, std::uint32_t most) {
  const std::uint32_t least = counts.visits + kTrianglePairWork * counts.leaf_pairs;
  const std::uint32_t others = counts.visits * (kShapeWork + most + kGoOnWork);
  return work >= least &&
         work <= counts.visits + kTrianglePairWork * counts.leaf_pairs * most * most + others;
}

}  // namespace

TEST_CASE("a run tests no more triangles than it is granted, and a step beyond, and gets on") {
  std::uint32_t inside_leaves = 0;
  for_rounds(rounds(40, 150), 8, [&](Random& random, int) {
    const Scene scene = any_scene(random);
    const Mesh& a = scene.a;
    const Mesh& b = scene.b;
    PairQuery whole(a, b, scene.pose);
    const Pairs expected = run_to_end(whole);
    std::uint32_t tests = 0;
    Query<Ranked<Mesh>, CountedTests> query(a, b, scene.pose, {}, {{}, &tests});
    Pairs pairs;
    std::uint64_t spent = 0;
    std::uint32_t runs = 0;
    for (Status status = Status::suspended; status != Status::done; ++runs) {
      const std::uint32_t work = 1 + random.below(random.below(2) == 0 ? 4 : 100);
      CAPTURE(work, runs);
      const QueryStats before = query.stats();
      const QueryCursor<std::uint16_t> was = query.cursor();
      tests = 0;
      const RunResult step = query.run(work, [&](const auto& pair) {
        pairs.emplace_back(pair.a, pair.b);
        return true;
      });
      status = step.status;
      REQUIRE((status == Status::done || (status == Status::suspended && step.work == work)));
      REQUIRE(tests <= triangle_pairs_for(work));
      REQUIRE(query.stats().visits - before.visits <= work);
      const QueryCursor<std::uint16_t> is = query.cursor();
      REQUIRE(
          (is.a != was.a || is.b != was.b || is.state != was.state || is.untested != was.untested));
      spent += step.work;
      inside_leaves += is.untested != 0 && was.untested != 0 ? 1 : 0;
    }
    REQUIRE(pairs == expected);
    REQUIRE(same(query.stats(), whole.stats()));
    // Each run may have overdrawn by a step, but saves no work.
    const TreeSize size_a = size_of(a);
    const TreeSize size_b = size_of(b);
    REQUIRE(spent <= most_work(size_a, size_b) + runs * largest_step(size_a, size_b));
  });
  CHECK(inside_leaves > 100);
}

TEST_CASE("work is visits, shapes and pairs of triangles") {
  for_rounds(200, 9, [&](Random& random, int) {
    const Scene scene = any_scene(random);
    const Mesh& a = scene.a;
    const Mesh& b = scene.b;
    const std::uint32_t most = std::max(size_of(a).leaf_size, size_of(b).leaf_size);
    constexpr std::uint32_t kGranted = 60000;
    std::vector<PairQuery::Pair> found(1000);
    PairQuery query(a, b, scene.pose);
    const RunResult step = query.run(kGranted, found.data(), 1000);
    REQUIRE(step.status == Status::done);
    REQUIRE(is_work_of(query.stats(), step.work, most));
    if (most == 1) {  // by boxes alone there are no leaf planes
      Query<Ranked<Mesh>, BoxIntersection> boxes(a, b, scene.pose);
      const std::uint32_t work = boxes.run(kGranted, found.data(), 1000).work;
      const QueryStats& counts = boxes.stats();
      REQUIRE(work == counts.visits + kTrianglePairWork * counts.leaf_pairs);
    }
    PairQuery unlimited(a, b, scene.pose);
    REQUIRE(unlimited.run(UINT32_MAX, found.data(), 1000).work == 0);
    PairQuery none(a, b, scene.pose);
    const RunResult nothing = none.run(0, found.data(), 1000);
    REQUIRE((nothing.status == Status::suspended && nothing.work == 0 && nothing.count == 0));
    REQUIRE(none.cursor().state == State::fresh);
  });
}

TEST_CASE("a pair of leaves may take more work than one walk may") {
  Random random = test_random(10);
  const auto mesh_a = random_mesh(random, 255, 60, 60);
  const auto mesh_b = random_mesh(random, 510, 60, 60);
  const AnyMesh a(bake::build_median(mesh_a, kMaxLeafSize), mesh_a);
  const AnyMesh b(bake::build_median(mesh_b, kMaxLeafSize), mesh_b);
  REQUIRE(a.triangles_in(0) * b.triangles_in(0) * kTrianglePairWork > 65535);
  const Pose pose = Pose::translated(3, 2, 1);
  PairQuery whole(a, b, pose);
  const Pairs expected = run_to_end(whole);
  CHECK(whole.stats().leaf_pairs > 1);
  for (const std::uint32_t work : {33u, 1000u, 65535u, 65536u, 100000u, 5000000u, 4000000000u}) {
    CAPTURE(work);
    PairQuery cut(a, b, pose);
    REQUIRE(run_to_end(cut, work) == expected);
    REQUIRE(same(cut.stats(), whole.stats()));
    PairQuery resumed(a, b, pose);
    std::vector<PairQuery::Pair> found(1000);
    const RunResult step = resumed.run(work, found.data(), 1000);
    PairQuery other(a, b, pose);
    REQUIRE(other.resume(resumed.cursor()) != Status::cursor_invalid);
    const Pairs rest = run_to_end(other, work);
    REQUIRE(step.count + rest.size() == expected.size());
    REQUIRE(std::equal(rest.begin(), rest.end(), expected.begin() + step.count));
  }
}
