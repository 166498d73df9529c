
#include <algorithm>
#include <tuple>

#include "robot/replay/replay.hpp"

namespace flashbvh::tool {
namespace {

/// Larger weights are shown sooner. Refused values are reported elsewhere, too.
auto weight(const Stretch& stretch) {
  constexpr std::size_t kWeights[kPeriodKinds] = {0, 1, 3, 4, 2};
  return std::tuple(kWeights[stretch.kind], stretch.last - stretch.first);
}

void take_least(std::optional<std::uint32_t> found, std::optional<std::uint32_t>& least) {
  if (found && (!least || *found < *least)) {
    least = found;
  }
}

/// The robot with one of its pairs, without a distance table.
Robot with_one_pair(const Robot& robot, std::uint16_t pair) {
  Robot one = robot;
  one.pairs += pair;
  one.pair_count = 1;
  one.distance_tables = nullptr;
  one.distance_table_bytes = 0;
  return one;
}

/// The verdicts of a guard of its own for each pair, with unlimited work; `not_yet_known` is from
/// the answers.
std::vector<NearPair> named_pairs(const Robot& robot, const Trajectory& trajectory,
                                  const std::vector<GuardAnswer>& answers) {
  std::vector<NearPair> pairs(robot.pair_count);
  for (std::uint16_t i = 0; i < robot.pair_count; ++i) {
    pairs[i].pair = i;
    for (const GuardAnswer& answer : replay(with_one_pair(robot, i), trajectory, kAllWork)) {
      if (answer.pair != kNoPair) {
        ++pairs[i].named[kind_of(answer)];
      }
    }
  }
  for (const GuardAnswer& answer : answers) {
    if (answer.pair != kNoPair && answer.verdict == Verdict::not_yet_known) {
      ++pairs[answer.pair].named[kind_of(answer)];
    }
  }
  return pairs;
}

bool is_named(const NearPair& pair) {
  return std::any_of(pair.named.begin() + 1, pair.named.end(),
                     [](std::size_t periods) { return periods != 0; });
}

void measure(const Robot& robot, std::size_t period, PosedPairs& posed, NearPair& pair) {
  const RobotPair& links = robot.pairs[pair.pair];
  if (!is_named(pair) && !posed.is_within(pair.pair, links.warn)) {
    return;
  }
  const std::optional<std::uint32_t> found = posed.distance_of(pair.pair);
  if (!found) {
    return;
  }
  pair.within_stop += *found <= links.stop ? 1 : 0;
  pair.within_warn += *found <= links.warn ? 1 : 0;
  if (!pair.closest || *found < *pair.closest) {
    pair.closest = found;
    pair.closest_period = period;
  }
}

/// Larger weights come sooner in the list.
auto weight(const NearPair& pair) {
  constexpr auto kWarn = static_cast<std::size_t>(Verdict::warn);
  constexpr auto kUnknown = static_cast<std::size_t>(Verdict::not_yet_known);
  constexpr auto kStop = static_cast<std::size_t>(Verdict::stop);
  return std::tuple(std::max(pair.named[kStop], pair.within_stop), pair.named[kUnknown],
                    std::max(pair.named[kWarn], pair.within_warn));
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

std::vector<NearPair> near_pairs(const Robot& robot, const Trajectory& trajectory,
                                 const std::vector<GuardAnswer>& answers) {
  std::vector<NearPair> pairs = named_pairs(robot, trajectory, answers);
  PosedPairs posed(robot);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (posed.take(trajectory.values(i))) {
      for (NearPair& pair : pairs) {
        measure(robot, i, posed, pair);
      }
    }
  }
  pairs.erase(
      std::remove_if(pairs.begin(), pairs.end(),
                     [](const NearPair& pair) { return !is_named(pair) && pair.within_warn == 0; }),
      pairs.end());
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const NearPair& p, const NearPair& q) { return weight(p) > weight(q); });
  return pairs;
}

}  // namespace flashbvh::tool
