// Distances of links that do not intersect: without a hint, and with the witness of a pose 10 cells
// away as a hint, which must not change them.
#include "costs.hpp"
#include "flashbvh/clearance.hpp"
#include "links.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr int32_t kStep = 10;  // cells

Clearance<uint16_t> add_distance(const char* hint, const LinkPair& pair, const PoseKey& key,
                                 const Witness<uint16_t>& seed) {
  const Pose pose = key.pose();
  Clearance<uint16_t> found{};
  measure({{"distance", key.motion(), key.proximity_name(), hint}},
          [&] { found = distance(*pair.a, *pair.b, pose, seed); });
  add_to_digest(found.lower);
  add_to_digest(found.upper);
  return found;
}

}  // namespace

bool measure_distances() {
  return for_each_pose([](const LinkPair& pair, const PoseKey& key) {
    if (key.proximity == Proximity::intersecting) {
      return true;
    }
    const Clearance<uint16_t> near = distance(*pair.a, *pair.b, key.pose(kStep));
    const Clearance<uint16_t> cold = add_distance("cold", pair, key, {});
    const Clearance<uint16_t> hint = add_distance("hint", pair, key, near.witness);
    return cold.status == Status::done && cold.lower == hint.lower && cold.upper == hint.upper;
  });
}

}  // namespace figures
