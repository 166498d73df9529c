#include "report/guard_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "flashbvh/version.hpp"
#include "report/closest_pictures.hpp"
#include "report/distance_chart.hpp"
#include "report/html.hpp"
#include "report/raster.hpp"
#include "report/style.hpp"
#include "robot/replay_summary.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Places along the chart: more can't be told apart.
constexpr std::size_t kMostPlaces = 1500;
constexpr std::size_t kMostLines = 4;

std::string links_of(const GuardedTrajectory& guarded, std::size_t pair) {
  const RobotPair& links = guarded.robot.pairs[pair];
  return guarded.model.links[links.a].name + " - " + guarded.model.links[links.b].name;
}

double metres_of(const GuardedTrajectory& guarded, std::uint32_t fine) {
  double cell = 0;
  std::memcpy(&cell, &guarded.robot.cell_bits, sizeof cell);
  return fine * cell / kFineOne;
}

std::string counts(const GuardedTrajectory& guarded) {
  const ReplaySummary summary = summary_of(guarded.answers);
  const auto tile = [](const std::string& name, const std::string& value, const std::string& note) {
    return concat("<div><dt>", name, "</dt><dd>", value, "<small>", note, "</small></dd></div>\n");
  };
  std::string html = "<section><h2>Periods</h2>\n<dl class=facts>\n";
  for (const std::size_t kind : kKindsInOrder) {
    html += tile(kKindNames[kind], grouped(summary.periods[kind]),
                 kind == 0 || summary.periods[kind] == 0
                     ? ""
                     : concat("first at line ", guarded.trajectory.line(summary.first[kind])));
  }
  return html +
         tile("work a period", grouped(summary.most),
              concat("at most; ", fixed(summary.mean, 1), " on average, ",
                     grouped(summary.percentile_999), " at the 99.9th percentile, ",
                     grouped(summary.priming), " to prime")) +
         "</dl></section>\n";
}

/// The pairs that come nearest, the nearest first.
std::vector<DistanceLine> nearest_lines(const GuardedTrajectory& guarded, std::size_t step) {
  std::vector<DistanceLine> lines;
  for (auto& metres : distances_over(guarded.robot, guarded.trajectory, step)) {
    lines.push_back({links_of(guarded, lines.size()), std::move(metres)});
  }
  const auto least = [](const DistanceLine& line) {
    double metres = HUGE_VAL;
    for (const std::optional<double>& at : line.metres) {
      metres = std::min(metres, at.value_or(HUGE_VAL));
    }
    return metres;
  };
  std::stable_sort(lines.begin(), lines.end(),
                   [&](const auto& p, const auto& q) { return least(p) < least(q); });
  lines.resize(std::min(lines.size(), kMostLines));
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
  const RobotPair& pair = guarded.robot.pairs[0];  // all have the same distances
  const DistanceChart chart = {
      nearest_lines(guarded, step),  runs_of(guarded.answers),
      metres_of(guarded, pair.stop), metres_of(guarded, pair.warn),
      concat("line ", way.line(0)),  concat("line ", way.line(way.size() - 1))};
  return "<section><h2>Distances</h2>\n" + drawn(chart) +
         (step == 1 ? "" : concat("<p class=note>One line in ", step, " is measured.</p>\n")) +
         "</section>\n";
}

std::string closest_section(const GuardedTrajectory& guarded) {
  const auto closest = closest_moment(guarded.robot, guarded.trajectory);
  if (!closest) {
    return "";
  }
  const double metres = metres_of(guarded, closest->clearance.lower);
  return concat("<section><h2>Closest at line ", guarded.trajectory.line(closest->period), ": ",
                escaped(links_of(guarded, closest->pair)),
                metres == 0 ? " intersect" : ", " + significant(metres, 4) + " m", "</h2>\n",
                closest_pictures(guarded, *closest), "</section>\n");
}

}  // namespace

std::string guard_page(const GuardedTrajectory& guarded) {
  const std::string title = escaped(guarded.model.name);
  std::string html =
      "<!DOCTYPE html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n"
      "<meta name=viewport content=\"width=device-width,initial-scale=1\">\n<title>" +
      title + " &middot; flashbvh guard</title>\n<style>\n" + kColours + kText + kTables +
      kPictures + paint_style() + chart_style() + "</style>\n</head>\n<body>\n<header>\n" +
      "<p class=lead>flashbvh guard: a trajectory, as firmware's guard sees it</p>\n<h1>" + title +
      "</h1>\n</header>\n<main>\n" + counts(guarded);
  if (guarded.robot.pair_count != 0) {
    html += chart_section(guarded) + closest_section(guarded);
  }
  return html + concat("<footer><p class=note>flashbvh ", FLASHBVH_VERSION_MAJOR, ".",
                       FLASHBVH_VERSION_MINOR, ".", FLASHBVH_VERSION_PATCH,
                       "</p></footer>\n</main>\n</body>\n</html>\n");
}

}  // namespace flashbvh::tool
