// Measures runs of queries on hard meshes under many poses, for comparison with the proven bounds:
//   run KIND WORK VISITS LEAF_PAIRS DEPTHS LEAF_SIZE INSTRUCTIONS
//   make INSTRUCTIONS
// If a full array stopped a run, its walk may be further ahead, and VISITS and LEAF_PAIRS are those
// that its work allows. KIND: `translated`, `rotated`, or `itself`. LEAF_SIZE: the larger one.
#include "flashbvh/image.hpp"
#include "hard_mesh.hpp"
#include "insn.hpp"
#include "slice.hpp"
#include "support/rotations.hpp"
#include "text.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using flashbvh::test::Random;

namespace bound {
namespace {

constexpr uint32_t kScenes = 40;
constexpr uint32_t kPoses = 4;
constexpr uint32_t kRunsPerQuery = 24;
constexpr uint32_t kRunsOfItself = 8;
constexpr uint32_t kGranted[] = {1, 40, 400};
constexpr uint64_t kSeed = 0x626F756E64u;

// Static, since the smallest core's stack is too small.
Side side_a;
Side side_b;
Slice slice;

Pose any_pose(Random& random, int32_t reach) {
  // Usually near enough to intersect; sometimes in one place.
  const int32_t far = random.below(3) == 0 ? 0 : random.below(2) == 0 ? reach / 4 : reach;
  if (random.below(2) == 0) {
    return test::any_rigid_pose(random, far);
  }
  const int32_t x = random.between(-far, far);
  const int32_t y = random.between(-far, far);
  return Pose::translated(x, y, random.below(2) == 0 ? 0 : random.between(-far, far));
}

template <class QueryType>
void measure_run(const QueryType& query, void (*run)(void*), const char* kind, const Side& a,
                 const Side& b) {
  const QueryStats before = query.stats();
  const bool pending = query.cursor().untested != 0;
  const uint32_t instructions = port::instructions_of_call(run, &slice);
  bound_done();
  const bool full = slice.step.status == Status::full;
  const uint32_t visits = full ? slice.work : query.stats().visits - before.visits;
  const uint32_t leaf_pairs = full ? slice.work / kTrianglePairWork + 1
                                   : query.stats().leaf_pairs - before.leaf_pairs + pending;
  port::print("run ", kind, " ", slice.work, " ", visits, " ", leaf_pairs, " ");
  port::print(a.depth + b.depth, " ", a.leaf_size > b.leaf_size ? a.leaf_size : b.leaf_size, " ",
              instructions, "\n");
}

void measure_itself(const Side& side, uint32_t granted) {
  SelfQuery query(side.tree.view());
  slice.itself = &query;
  slice.work = granted;
  for (uint32_t i = 0; i < kRunsOfItself && query.status() == Status::suspended; ++i) {
    measure_run(query, bound_run_itself, "itself", side, side);
  }
}

void measure_query(const Pose& pose, uint32_t granted) {
  const Mesh& a = side_a.tree.view();
  const Mesh& b = side_b.tree.view();
  PairQuery query(a, b, pose);
  slice.a = &a;
  slice.b = &b;
  slice.pose = &pose;
  slice.query = &query;
  slice.work = granted;
  const uint32_t making = port::instructions_of_call(bound_make_query, &slice);
  bound_done();
  port::print("make ", making, "\n");
  for (uint32_t i = 0; i < kRunsPerQuery; ++i) {
    measure_run(query, bound_run, pose.is_translation() ? "translated" : "rotated", side_a, side_b);
    if (slice.step.status == Status::done) {
      return;
    }
  }
}

bool measure_all() {
  Random random(kSeed);
  for (uint32_t i = 0; i < kScenes; ++i) {
    constexpr int32_t reaches[] = {3, 100, 4000, kMaxCoordinate};
    const int32_t reach = reaches[i % 4];
    if (!make_side(random, reach, side_a) || !make_side(random, reach, side_b)) {
      return false;
    }
    for (const uint32_t granted : kGranted) {
      measure_itself(side_a, granted);
    }
    for (uint32_t j = 0; j < kPoses; ++j) {
      const Pose pose = any_pose(random, reach);
      for (const uint32_t granted : kGranted) {
        measure_query(pose, granted);
      }
    }
  }
  return true;
}

}  // namespace
}  // namespace bound

int main() {
  return bound::measure_all() ? 0 : 1;
}
