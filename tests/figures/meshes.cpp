// Meshes that are no robot's, pair by pair, as callers query them: from the pose to the result.
// Ends with 1 if a query counts anything else than on the host, or a hint changes a distance.
#include "flashbvh/clearance.hpp"
#include "flashbvh/collide.hpp"

#include "asked.hpp"
#include "measure.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr int32_t kStep = 10;  // cells, from the pose whose answer is the hint

Pose pose_before(Asked asked) {
  asked.cells[0] += kStep;
  return pose_of(asked);
}

bool add_queries(const Asking& asking, const AskedPair& pair, const Asked& asked) {
  const Pose pose = pose_of(asked);
  RunResult all{};
  measure(asking.whole("query"), [&] { all = count_pairs(*pair.a, *pair.b, pose); });
  Answer one{};
  measure(asking.whole("first"), [&] { one = intersects(*pair.a, *pair.b, pose); });
  PairQuery query(*pair.a, *pair.b, pose);
  (void)query.run(UINT32_MAX, [](const PairQuery::Pair&) { return true; });
  add_count(asking.whole("visits"), query.stats().visits);
  add_to_digest(query.stats());
  return all.status == Status::done && query.stats().visits == asked.visits &&
         all.count == asked.triangle_pairs && one.yes == (all.count != 0);
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

bool measure_pair(const AskedPair& pair) {
  bool right = true;
  constexpr bool kRotated[] = {false, true};
  for (const bool rotated : kRotated) {
    for (uint32_t i = 0; i < kProximities; ++i) {
      const Asking asking = {pair.a_name, rotated ? "rotated" : "translated", kProximityNames[i]};
      for (const Asked& asked : (rotated ? pair.rotated : pair.translated)[i]) {
        right = add_queries(asking, pair, asked) && right;
        if (static_cast<Proximity>(i) != Proximity::intersecting) {
          right = add_distances(asking, pair, asked) && right;
        }
      }
    }
  }
  print_rows();
  return right;
}

}  // namespace
}  // namespace figures

int main() {
  bool right = true;
  for (uint32_t p = 0; p < figures::kAskedPairCount; ++p) {
    right = figures::measure_pair(figures::kAskedPairs[p]) && right;
  }
  return figures::print_all("others", right);
}
