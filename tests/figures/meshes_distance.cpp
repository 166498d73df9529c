// Distances of meshes other than robots, where they do not intersect. Exits with 1 if a hint
// changes a distance.
#include "flashbvh/clearance.hpp"

#include "others.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr int32_t kStep = 10;  // cells, from the pose whose answer is the hint

Pose pose_before(Asked asked) {
  asked.cells[0] += kStep;
  return pose_of(asked);
}

bool add_distances(const Asking& asking, const AskedPair& pair, const Asked& asked) {
  const Pose pose = pose_of(asked);
  const auto before = distance(*pair.a, *pair.b, pose_before(asked));
  Clearance<uint16_t> cold{};
  Clearance<uint16_t> hinted{};
  measure(asking.whole("cold"), [&] { cold = distance(*pair.a, *pair.b, pose); });
  measure(asking.whole("hint"), [&] { hinted = distance(*pair.a, *pair.b, pose, before.witness); });
  add_to_digest(cold.lower);
  add_to_digest(cold.upper);
  return cold.status == Status::done && cold.lower == hinted.lower && cold.upper == hinted.upper;
}

}  // namespace
}  // namespace figures

int main() {
  return figures::measure_others("others_distance", [](const auto& asking, const auto& pair,
                                                       const auto& asked) {
    return asking.proximity ==
               figures::kProximityNames[static_cast<uint32_t>(figures::Proximity::intersecting)] ||
           figures::add_distances(asking, pair, asked);
  });
}
