// Distances of meshes other than robots, where they do not intersect. Exits with 1 if a hint
// changes a distance.
#include "flashbvh/clearance.hpp"

#include "others.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr int32_t kStep = 10;  // cells, from the pose whose answer is the hint

Pose pose_before(QueryPose query_pose) {
  query_pose.cells[0] += kStep;
  return pose_of(query_pose);
}

bool add_distances(const FigureNames& names, const MeshPair& pair, const QueryPose& query_pose) {
  const Pose pose = pose_of(query_pose);
  const auto before = distance(*pair.a, *pair.b, pose_before(query_pose));
  Clearance<uint16_t> cold{};
  Clearance<uint16_t> hinted{};
  measure(names.whole("cold"), [&] { cold = distance(*pair.a, *pair.b, pose); });
  measure(names.whole("hint"), [&] { hinted = distance(*pair.a, *pair.b, pose, before.witness); });
  add_to_digest(cold.lower);
  add_to_digest(cold.upper);
  return cold.status == Status::done && cold.lower == hinted.lower && cold.upper == hinted.upper;
}

}  // namespace
}  // namespace figures

int main() {
  return figures::measure_others("others_distance", [](const auto& names, const auto& pair,
                                                       const auto& query_pose) {
    return names.proximity ==
               figures::kProximityNames[static_cast<uint32_t>(figures::Proximity::intersecting)] ||
           figures::add_distances(names, pair, query_pose);
  });
}
