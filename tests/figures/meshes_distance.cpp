// Distances of meshes other than robots, where they do not intersect. Exits with 1 if a hint
// changes a distance.
#include "flashbvh/clearance.hpp"

#include "others.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr int32_t kStep = 10;  // cells, from the pose whose answer is the hint

bool measure_pose(const MeshPair& pair, const QueryPose& query_pose, const char* motion,
                  const char* proximity) {
  if (proximity == kProximityNames[static_cast<uint32_t>(Proximity::intersecting)]) {
    return true;
  }
  const FigureNames names = {pair.a_name, motion, proximity};
  const Pose pose = pose_of(query_pose);
  const auto before = distance(*pair.a, *pair.b, pose_of(query_pose, kStep));
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
  return figures::measure_others("others_distance", figures::measure_pose);
}
