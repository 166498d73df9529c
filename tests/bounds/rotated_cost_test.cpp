// Instructions per visit under rotation, counted on the target over walks at many poses.
#include <catch2/catch.hpp>

#include <cstdio>

#include "flashbvh/detail/bounds/box_rotated.hpp"
#include "flashbvh/query.hpp"
#include "insn.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"
#include "support/torus.hpp"
#include "support/walk.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

#if defined(__ARM_FEATURE_DSP)
constexpr double kMostPerVisit = 90;
#elif defined(__riscv)
constexpr double kMostPerVisit = 150;
#else
constexpr double kMostPerVisit = 120;
#endif

Baked<Layout::post_indexed> median(const bake::LatticeMesh& mesh) {
  return baked(bake::build_median(mesh, 1), mesh);
}

struct Cost {
  std::uint32_t visits = 0;
  std::uint32_t overlaps = 0;
  std::uint32_t leaf_pairs = 0;
  std::uint32_t instructions = 0;
};

/// A walk over boxes alone, from the root, with the preparation of the pose.
void add_walk(const Mesh& a, const Mesh& b, const Pose& pose, Cost& cost) {
  QueryStats counts = {1, 0, 0, 0};
  std::uint32_t leaf_pairs = 0;
  const std::uint32_t instructions = port::instructions_of([&] {
    RotatedTransform transform;
    if (!transform.prepare(pose, a.origin, a.nodes[0].box, b.origin, b.nodes[0].box, true)) {
      return;
    }
    RotatedBoxTest overlap(transform);
    PairCursor<std::uint16_t> cursor;
    const auto leaf_pair = [&leaf_pairs](std::uint32_t, std::uint32_t, const Progress&) {
      ++leaf_pairs;
      return true;
    };
    counts = walk_from<Ranked<Mesh>>(a, b, ByReference<RotatedBoxTest>{&overlap}, cursor, leaf_pair)
                 .counts;
  });
  cost.visits += counts.visits;
  cost.overlaps += counts.overlaps;
  cost.leaf_pairs += leaf_pairs;
  cost.instructions += instructions;
}

}  // namespace

TEST_CASE("instructions of a visit under rotation stay within their budget") {
  const auto thick = median(torus(20, 20, 6000, 2000));
  const auto thin = median(torus(40, 10, 7000, 800));
  const auto a = thick.view();
  const auto b = thin.view();
  Cost all;
  for (const std::int32_t reach : {2000, 6000, 12000, 20000}) {
    Random random = test_random();
    Cost cost;
    for (int i = 0; i < 30; ++i) {
      add_walk(a, b, any_rigid_pose(random, reach), cost);
      add_walk(b, a, any_rigid_pose(random, reach), cost);
    }
    std::printf(
        "within %5d cells: %8u visits, %2u %% overlap, %2u %% pairs of leaves, %6.2f each\n",
        static_cast<int>(reach), static_cast<unsigned>(cost.visits),
        static_cast<unsigned>(100 * cost.overlaps / cost.visits),
        static_cast<unsigned>(100 * cost.leaf_pairs / cost.visits),
        static_cast<double>(cost.instructions) / cost.visits);
    all.visits += cost.visits;
    all.instructions += cost.instructions;
  }
  const double per_visit = static_cast<double>(all.instructions) / all.visits;
  std::printf("budget: a rotated visit: %.2f instructions, at most %.0f\n", per_visit,
              kMostPerVisit);
  std::fflush(stdout);
  CHECK(per_visit <= kMostPerVisit);
}
