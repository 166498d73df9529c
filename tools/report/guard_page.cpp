#include "report/guard_page.hpp"

#include <algorithm>
#include <cmath>

#include "report/arm_pictures.hpp"
#include "report/chart.hpp"
#include "report/html.hpp"
#include "robot/replay_summary.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Places along the chart: more can't be told apart.
constexpr std::size_t kMostPlaces = 1500;
constexpr std::size_t kMostLines = 4;

/// So many times the warn distance is shown.
constexpr double kShownFold = 5;

double metres_of(const GuardedTrajectory& guarded, std::uint32_t fine) {
  return fine * cell_of(guarded.robot) / kFineOne;
}

std::string counts(const GuardedTrajectory& guarded) {
  const ReplaySummary summary = summary_of(guarded.answers);
  std::string html = "<section><h2>Periods</h2>\n<dl class=facts>\n";
  for (const std::size_t kind : kKindsInOrder) {
    html += fact(kKindNames[kind], grouped(summary.periods[kind]),
                 kind == 0 || summary.periods[kind] == 0
                     ? ""
                     : concat("first at line ", guarded.trajectory.line(summary.first[kind])));
  }
  return html +
         fact("work a period", grouped(summary.most),
              concat("at most; ", fixed(summary.mean, 1), " on average, ",
                     grouped(summary.percentile_999), " at the 99.9th percentile, ",
                     grouped(summary.priming), " to prime")) +
         "</dl></section>\n";
}

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

/// The pairs that come nearest, the nearest first; besides it, those that come within `most`.
std::vector<ChartLine> nearest_lines(const GuardedTrajectory& guarded, std::size_t step,
                                     double most) {
  std::vector<ChartLine> lines;
  for (auto& metres : distances_over(guarded.robot, guarded.trajectory, step)) {
    lines.push_back({pair_name(guarded, lines.size()), std::move(metres)});
  }
  const auto least = [](const ChartLine& line) {
    double metres = HUGE_VAL;
    for (const std::optional<double>& at : line.values) {
      metres = std::min(metres, at.value_or(HUGE_VAL));
    }
    return metres;
  };
  std::stable_sort(lines.begin(), lines.end(),
                   [&](const auto& p, const auto& q) { return least(p) < least(q); });
  lines.resize(std::min(lines.size(), kMostLines));
  while (most > 0 && lines.size() > 1 && least(lines.back()) > most) {
    lines.pop_back();
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].colour = i;
  }
  return lines;
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

std::string chart_section(const GuardedTrajectory& guarded) {
  const Trajectory& way = guarded.trajectory;
  const std::size_t step = (way.size() + kMostPlaces - 1) / kMostPlaces;
  const std::string first = concat("line ", way.line(0));
  const std::string last = concat("line ", way.line(way.size() - 1));
  const double stop = metres_of(guarded, guarded.robot.pairs[0].stop);  // all have the same ones
  const double warn = metres_of(guarded, guarded.robot.pairs[0].warn);
  std::vector<ChartLine> lines = nearest_lines(guarded, step, kShownFold * warn);
  const auto least = [](const auto& p, const auto& q) { return std::min(p, q); };
  const auto most = [](const auto& p, const auto& q) { return std::max(p, q); };
  lines.push_back({"known to the guard", folded(known_metres(guarded), step, least), kMostLines});
  Chart work = {"Work over time", "", {}, {}, 0, {}, first, last, "After the first period."};
  work.lines = {{"work of each period", folded(work_of(guarded.answers), step, most), 0}};
  if (guarded.work != kAllWork) {
    work.levels = {{static_cast<double>(guarded.work), "stop"}};
    work.caption += concat(" Dashed: what a period may spend, ", grouped(guarded.work),
                           "; a step may overdraw it.");
  }
  return "<section><h2>Distances</h2>\n" +
         drawn({"Distances over time",
                " m",
                lines,
                {{stop, "stop"}, {warn, "warn"}},
                kShownFold * warn,
                runs_of(guarded.answers),
                first,
                last,
                "Distance of the meshes in each period, of the pairs that come near; dotted: the "
                "least that the guard knows of all; dashed: the stop and the warn distance. Below: "
                "what the guard says. What is far above is cut off."}) +
         (step == 1 ? "" : concat("<p class=note>One line in ", step, " is measured.</p>\n")) +
         "<h3>Work</h3>\n" + drawn(work) + "</section>\n";
}

std::string closest_section(const GuardedTrajectory& guarded) {
  const auto closest = closest_moment(guarded.robot, guarded.trajectory);
  if (!closest) {
    return "";
  }
  const double metres = metres_of(guarded, closest->clearance.lower);
  const RobotPair& links = guarded.robot.pairs[closest->pair];
  const float* const values = guarded.trajectory.values(closest->period);
  return concat("<section><h2>Closest at line ", guarded.trajectory.line(closest->period), ": ",
                pair_name(guarded, closest->pair),
                metres == 0 ? " intersect" : ", " + significant(metres, 4) + " m", "</h2>\n",
                pair_pictures({guarded.model, guarded.robot, link_poses(guarded.robot, values)},
                              {links.a, links.b, closest->clearance.triangles,
                               "the triangles that are nearest"}),
                "<p class=note>Joints: <code>",
                joint_values(guarded.model, {values, values + guarded.trajectory.variables()}),
                "</code></p>\n</section>\n");
}

}  // namespace

std::string pair_name(const GuardedTrajectory& guarded, std::size_t pair) {
  return links_of(guarded.model, guarded.robot.pairs[pair].a, guarded.robot.pairs[pair].b);
}

std::string guard_page(const GuardedTrajectory& guarded) {
  std::string html =
      page_begin(escaped(guarded.model.name), "guard",
                 "a trajectory, as firmware&#39;s guard sees it", chart_style() + arm_style()) +
      counts(guarded);
  if (guarded.robot.pair_count != 0) {
    html += chart_section(guarded) + closest_section(guarded);
  }
  return html + motion_section(guarded) + page_end();
}

}  // namespace flashbvh::tool
