// Two tori in random poses, and pairs of triangles of the costliest kinds: what can be measured
// anywhere, without a robot's meshes.
#include "insn.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "support/rotations.hpp"
#include "support/triangle_kinds.hpp"
#include "thick.fbvh.hpp"
#include "thin.fbvh.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace figures {
namespace {

constexpr const char* kSet = "tori";
constexpr uint64_t kSeed = 20240607;
constexpr int32_t kReaches[] = {2000, 6000, 12000};
constexpr uint32_t kPosesOfReach = 20;

Pose any_pose(test::Random& random, int32_t reach, bool rotated) {
  if (rotated) {
    return test::any_rigid_pose(random, reach);
  }
  const int32_t x = random.between(-reach, reach);
  const int32_t y = random.between(-reach, reach);
  return Pose::translated(x, y, random.between(-reach, reach));
}

bool ask_all(const char* name, bool rotated) {
  test::Random random(kSeed);
  Motion motion;
  Spread visits;
  Spread leaf_pairs;
  Spread triangle_pairs;
  bool good = true;
  for (const int32_t reach : kReaches) {
    for (uint32_t i = 0; i < kPosesOfReach; ++i) {
      const Pose pose = any_pose(random, reach, rotated);
      const Walked walked = measure_walk(thick::mesh, thin::mesh, pose);
      const Queried queried = measure_query(thick::mesh, thin::mesh, pose);
      motion.add(walked, queried);
      visits.add(queried.counts.visits);
      leaf_pairs.add(queried.counts.leaf_pairs);
      triangle_pairs.add(queried.counts.triangle_pairs);
      counted.add(queried.counts);
      good = good && queried.status == Status::done && walked.visits == queried.counts.visits;
    }
  }
  print_counts({{kSet, "visits", name}}, visits);
  print_counts({{kSet, "leaf_pairs", name}}, leaf_pairs);
  print_counts({{kSet, "triangle_pairs", name}}, triangle_pairs);
  motion.print(kSet, name);
  return good;
}

void measure_kind(const test::TriangleKind& kind) {
  constexpr uint32_t kPairs = 300;
  test::Random random(kSeed);
  Spread tests;
  uint32_t intersecting = 0;
  for (uint32_t i = 0; i < kPairs; ++i) {
    Triangle a;
    Triangle b;
    test::set_random_pair(random, kind, a, b);
    bool intersects = false;
    tests.add(port::instructions_of([&] { intersects = triangles_intersect(a, b); }));
    intersecting += intersects ? 1 : 0;
  }
  counted.add(intersecting);
  print_figures({{"triangles", kind.name}}, tests);
}

bool run() {
  print_core();
  const bool translated = ask_all("translated", false);
  const bool rotated = ask_all("rotated", true);
  for (const test::TriangleKind& kind : test::kTriangleKinds) {
    measure_kind(kind);
  }
  print_count({{kSet, "digest"}}, counted.value());
  return translated && rotated;
}

}  // namespace
}  // namespace figures

int main() {
  return figures::run() ? 0 : 1;
}
