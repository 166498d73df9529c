#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "report/chart.hpp"
#include "report/guard_page.hpp"
#include "report/html.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Places along the chart: more would be indistinguishable.
constexpr std::size_t kMostPlaces = 1500;

/// So many times the warn distance is shown.
constexpr double kShownFold = 5;

/// A value a period, or none.
using Values = std::vector<std::optional<double>>;

/// By place along a chart, the worst of `step` periods.
template <class Worse>
Values folded(const Values& values, std::size_t step, const Worse& worse) {
  Values places;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % step == 0) {
      places.push_back(values[i]);
    }
    places.back() = worse(places.back(), values[i]);
  }
  return places;
}

/// Of all pairs, the least that the guard knows; where it knows nothing, none.
Values known_metres(const GuardedTrajectory& guarded) {
  Values values;
  for (const GuardAnswer& answer : guarded.answers) {
    values.emplace_back();
    if (answer.status == Status::done && answer.pair != kNoPair) {
      values.back() = metres_of(guarded, answer.distance);
    }
  }
  return values;
}

/// After the period that primes the guard.
Values work_of(const std::vector<GuardAnswer>& answers) {
  Values values;
  bool is_primed = false;
  for (const GuardAnswer& answer : answers) {
    values.emplace_back();
    if (is_primed) {
      values.back() = answer.work;
    }
    is_primed = is_primed || answer.status == Status::done;
  }
  return values;
}

double least_of(const Values& values) {
  double metres = HUGE_VAL;
  for (const std::optional<double>& at : values) {
    metres = std::min(metres, at.value_or(HUGE_VAL));
  }
  return metres;
}

std::vector<KindRun> runs_of(const std::vector<GuardAnswer>& answers) {
  std::vector<KindRun> runs;
  const auto count = static_cast<double>(answers.size());
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const std::size_t kind = kind_of(answers[i]);
    if (runs.empty() || runs.back().kind != kind) {
      runs.push_back({static_cast<double>(i) / count, 0, kind});
    }
    runs.back().end = static_cast<double>(i + 1) / count;
  }
  return runs;
}

/// The near pairs, then the nearest of the others that come within `most`, as there is place; one
/// at least.
std::vector<std::uint16_t> chosen_pairs(const std::vector<NearPair>& near,
                                        const std::vector<Values>& distances, double most) {
  std::vector<std::uint16_t> pairs;
  std::transform(near.begin(), near.end(), std::back_inserter(pairs),
                 [](const NearPair& pair) { return pair.pair; });
  std::vector<std::pair<double, std::uint16_t>> others;
  for (const Values& values : distances) {
    const auto pair = static_cast<std::uint16_t>(&values - distances.data());
    if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) {
      others.emplace_back(least_of(values), pair);
    }
  }
  std::sort(others.begin(), others.end());
  for (const auto& [least, pair] : others) {
    if (pairs.empty() || most <= 0 || least <= most) {
      pairs.push_back(pair);
    }
  }
  pairs.resize(std::min(pairs.size(), kMostLines));
  return pairs;
}

std::uint32_t farthest_warn(const Robot& robot) {
  std::uint32_t farthest = 0;
  for (std::uint16_t pair = 0; pair < robot.pair_count; ++pair) {
    farthest = std::max(farthest, robot.pairs[pair].warn);
  }
  return farthest;
}

/// Unless it is there.
void add_level(double metres, const char* name, std::vector<DistanceTableLevel>& levels) {
  if (std::none_of(levels.begin(), levels.end(), [&](const DistanceTableLevel& level) {
        return level.value == metres && level.name == std::string(name);
      })) {
    levels.push_back({metres, name, name});
  }
}

/// The pairs that are drawn, and the distances at which they are stopped and warned of.
void add_pairs(const GuardedTrajectory& guarded, const std::vector<NearPair>& near,
               std::size_t step, double most, std::vector<DistanceTableLine>& lines,
               std::vector<DistanceTableLevel>& levels) {
  const std::vector<Values> distances = distances_over(guarded.robot, guarded.trajectory, step);
  for (const std::uint16_t pair : chosen_pairs(near, distances, most)) {
    lines.push_back({pair_name(guarded, pair), distances[pair], lines.size()});
    add_level(metres_of(guarded, guarded.robot.pairs[pair].stop), "stop", levels);
    add_level(metres_of(guarded, guarded.robot.pairs[pair].warn), "warn", levels);
  }
}

}  // namespace

std::string chart_section(const GuardedTrajectory& guarded, const std::vector<NearPair>& near) {
  const Trajectory& way = guarded.trajectory;
  const std::size_t step = (way.size() + kMostPlaces - 1) / kMostPlaces;
  const std::string first = concat("line ", way.line(0));
  const std::string last = concat("line ", way.line(way.size() - 1));
  const double most_shown = kShownFold * metres_of(guarded, farthest_warn(guarded.robot));
  std::vector<DistanceTableLine> lines;
  std::vector<DistanceTableLevel> levels;
  add_pairs(guarded, near, step, most_shown, lines, levels);
  const auto least = [](const auto& p, const auto& q) { return std::min(p, q); };
  const auto most = [](const auto& p, const auto& q) { return std::max(p, q); };
  lines.push_back({"known to the guard", folded(known_metres(guarded), step, least), kMostLines});
  Chart work = {"Work over time", "", {}, {}, 0, {}, first, last, "After the first period."};
  work.lines = {{"work of each period", folded(work_of(guarded.answers), step, most), 0}};
  if (guarded.work != kAllWork) {
    work.levels = {{static_cast<double>(guarded.work), "stop", "--work"}};
    work.caption += concat(" Dashed: what a period may spend, ", grouped(guarded.work),
                           "; a step may overdraw it.");
  }
  return section(
      "", "Distances",
      drawn({"Distances over time", " m", lines, levels, most_shown, runs_of(guarded.answers),
             first, last,
             "Distance of the meshes in each period, of the pairs that come near; dotted: the "
             "least that the guard knows of all; dashed: the stop and the warn distance. Below: "
             "what the guard says. What is far above is cut off."}) +
          (step == 1 ? "" : note(concat("One line in ", step, " is measured."))) +
          "<h3>Work</h3>\n" + drawn(work));
}

}  // namespace flashbvh::tool
