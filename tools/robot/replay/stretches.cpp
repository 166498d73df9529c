
#include <algorithm>
#include <tuple>

#include "robot/replay/replay.hpp"

namespace flashbvh::tool {
namespace {

/// Larger weights are shown sooner. Refused values are reported elsewhere, too.
auto weight(const Stretch& stretch) {
  constexpr std::size_t kWeights[kPeriodKinds] = {0, 1, 2, 4, 5, 3};
  return std::tuple(kWeights[stretch.kind], stretch.last - stretch.first);
}

void take_least(std::optional<std::uint32_t> found, std::optional<std::uint32_t>& least) {
  if (found && (!least || *found < *least)) {
    least = found;
  }
}

}  // namespace

std::vector<Stretch> stretches_of(const Robot& robot, const Trajectory& trajectory,
                                  const std::vector<GuardAnswer>& answers) {
  std::vector<Stretch> stretches;
  PosedPairs posed(robot);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const GuardAnswer& answer = answers[i];
    const std::size_t kind = kind_of(answer);
    if (kind == 0) {
      continue;
    }
    const std::uint16_t pair = kind == kRefusedKind ? kNoPair : answer.pair;
    if (stretches.empty() || stretches.back().last + 1 != i || stretches.back().kind != kind ||
        stretches.back().pair != pair) {
      stretches.push_back({i, i, kind, pair, answer.distance, std::nullopt});
    }
    Stretch& stretch = stretches.back();
    stretch.last = i;
    stretch.kept = std::min(stretch.kept, answer.distance);
    if (pair != kNoPair && posed.take(trajectory.values(i))) {
      take_least(posed.distance_of(pair), stretch.closest);
    }
  }
  return stretches;
}

std::vector<Stretch> worst_of(std::vector<Stretch> stretches, std::size_t most) {
  if (stretches.size() > most) {
    std::stable_sort(stretches.begin(), stretches.end(),
                     [](const Stretch& p, const Stretch& q) { return weight(p) > weight(q); });
    stretches.resize(most);
    std::sort(stretches.begin(), stretches.end(),
              [](const Stretch& p, const Stretch& q) { return p.first < q.first; });
  }
  return stretches;
}

}  // namespace flashbvh::tool
