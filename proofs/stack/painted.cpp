// The painted stack of whole queries, for comparison with their call graphs (stack.py): lines
//   stack NAME painted BYTES
//   object NAME BYTES
// over meshes and poses at which queries take their deepest paths.
#include "proofs/stack/painted.hpp"

#include "proofs/time/hard_mesh.hpp"
#include "stack.hpp"
#include "support/rotations.hpp"
#include "text.hpp"

using namespace flashbvh;
using flashbvh::test::Random;

namespace {

constexpr uint32_t kScenes = 60;
constexpr int32_t kPoses = 6;
constexpr int32_t kReaches[] = {3, 100, 4000, kMaxCoordinate};

// Static, since the smallest core's stack is too small.
bound::Side side_a;
bound::Side side_b;

struct Painted {
  const char* name;
  port::Call call;
  uint32_t most;
};
Painted queries[] = {{"painted_query", painted_query, 0},
                     {"painted_distance", painted_distance, 0}};

Pose pose_of(Random& random, int32_t reach) {
  if (random.below(2) == 0) {
    return test::any_rigid_pose(random, reach);
  }
  const int32_t x = random.between(-reach, reach);
  const int32_t y = random.between(-reach, reach);
  return Pose::translated(x, y, 0);
}

bool paint_all() {
  Random random(0x7374616368u);
  for (uint32_t i = 0; i < kScenes; ++i) {
    const int32_t reach = kReaches[i % 4];
    if (!make_side(random, reach, side_a) || !make_side(random, reach, side_b)) {
      return false;
    }
    for (int32_t j = 0; j < kPoses; ++j) {
      const Pose pose = pose_of(random, j * reach / 4);
      painted::Scene scene = {
          &side_a.tree.view(), &side_b.tree.view(), &pose, UINT32_MAX, {}, {}, {}};
      for (Painted& each : queries) {
        const uint32_t bytes = port::stack_of_call(each.call, &scene);
        each.most = bytes > each.most ? bytes : each.most;
      }
    }
  }
  return true;
}

}  // namespace

int main() {
  const bool done = paint_all();
  for (const Painted& each : queries) {
    port::print("stack ", each.name, " painted ", each.most, "\n");
  }
  port::print("object PairQuery ", sizeof(PairQuery), "\nobject ClearanceQuery ",
              sizeof(ClearanceQuery), "\nobject Pose ", sizeof(Pose), "\n");
  return done ? 0 : 1;
}
