// The links of a KUKA KR5, pair by pair, in the poses of write_poses for four classes of proximity.
// Exits with 1 if a query's counts differ from the host's.
#include "asked.hpp"
#include "measure.hpp"

using namespace flashbvh;

namespace figures {
namespace {

bool ask(const AskedPair& pair, const Asked& asked, const char* motion, const char* proximity) {
  const Pose pose = pose_of(asked);
  QueryStats counts{};
  uint32_t work = 0;
  const bool agrees = add_query({"kr5", motion, proximity}, *pair.a, *pair.b, pose, counts, work);
  add_triangle_tests("kr5", *pair.a, *pair.b, pose);
  return agrees && work == asked.work && counts.visits == asked.visits &&
         counts.leaf_pairs == asked.leaf_pairs && counts.triangle_pairs == asked.triangle_pairs;
}

/// The cost of a pose made of integers, and of one composed of two others.
void measure_poses() {
  for (uint32_t p = 0; p < kAskedPairCount; ++p) {
    const Pose other = pose_of(kAskedPairs[p].rotated[1][0]);
    for (const Asked& asked : kAskedPairs[p].rotated[0]) {
      const int16_t(&q)[4] = asked.quaternion;
      const test::Rotation rotation = test::rotation_of({q[0], q[1], q[2], q[3]});
      const Pose world = pose_of(asked);
      Pose pose = Pose::translated(0, 0, 0);
      measure({{"pose", "rigid"}}, [&] { pose = Pose::rigid(rotation.entry, asked.cells); });
      measure({{"pose", "relative"}}, [&] { pose = Pose::relative(other, world); });
    }
  }
}

}  // namespace
}  // namespace figures

int main() {
  const bool right = figures::ask_all(figures::ask);
  figures::measure_poses();
  return figures::print_all("kr5", right);
}
