// The links of a KUKA KR5, pair by pair, in the poses of write_poses for four classes of proximity.
// Exits with 1 if a query's counts differ from the host's.
#include "measure.hpp"
#include "query_pose.hpp"

using namespace flashbvh;

namespace figures {
namespace {

bool measure_pose(const MeshPair& pair, const QueryPose& query_pose, const char* motion,
                  const char* proximity) {
  const Pose pose = pose_of(query_pose);
  QueryStats counts{};
  uint32_t work = 0;
  const bool agrees = add_query({"kr5", motion, proximity}, *pair.a, *pair.b, pose, counts, work);
  add_triangle_tests("kr5", *pair.a, *pair.b, pose);
  return agrees && work == query_pose.work && counts.visits == query_pose.visits &&
         counts.leaf_pairs == query_pose.leaf_pairs &&
         counts.triangle_pairs == query_pose.triangle_pairs;
}

/// The cost of a pose made of integers, and of one composed of two others.
void measure_poses() {
  for (uint32_t p = 0; p < kMeshPairCount; ++p) {
    const Pose other = pose_of(kMeshPairs[p].rotated[1][0]);
    for (const QueryPose& query_pose : kMeshPairs[p].rotated[0]) {
      const int16_t(&q)[4] = query_pose.quaternion;
      const test::Rotation rotation = test::rotation_of({q[0], q[1], q[2], q[3]});
      const Pose world = pose_of(query_pose);
      Pose pose = Pose::translated(0, 0, 0);
      measure({{"pose", "rigid"}}, [&] { pose = Pose::rigid(rotation.entry, query_pose.cells); });
      measure({{"pose", "relative"}}, [&] { pose = Pose::relative(other, world); });
    }
  }
}

}  // namespace
}  // namespace figures

int main() {
  const bool right = figures::for_each_query_pose(figures::measure_pose);
  figures::measure_poses();
  return figures::print_all("kr5", right);
}
