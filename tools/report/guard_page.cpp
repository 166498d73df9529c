#include "report/guard_page.hpp"

#include <algorithm>

#include "report/arm_pictures.hpp"
#include "report/chart.hpp"
#include "report/html.hpp"
#include "robot/replay/replay.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// "Stops at line 3": the first period of a kind, its pair, and how many there are.
std::string first_decision(const GuardedTrajectory& guarded, const ReplaySummary& summary,
                           std::size_t kind, const std::string& what) {
  if (summary.periods[kind] == 0) {
    return "";
  }
  const std::size_t first = summary.first[kind];
  const GuardAnswer& answer = guarded.answers[first];
  const bool has_pair = kind != kRefusedKind && answer.pair != kNoPair;
  return decision(concat("v", kind), concat(what, " line ", guarded.trajectory.line(first)),
                  (has_pair ? pair_name(guarded, answer.pair) + ", " : "") +
                      counted(summary.periods[kind], "period", "periods"));
}

std::string motion_decision(const GuardedTrajectory& guarded) {
  const auto& motions = guarded.motions;
  const auto first = std::find_if_not(motions.begin(), motions.end(), is_free);
  if (first == motions.end()) {
    return "";
  }
  const auto number = static_cast<std::size_t>(first - motions.begin());
  const bool is_refused = first->answer.status != Status::done;
  return decision(is_refused ? "v4" : "v3",
                  concat("Motion to line ", guarded.trajectory.line(number + 1), ": ",
                         is_refused ? "refused" : outcome_name(first->answer.outcome)),
                  is_refused ? "" : pair_name(guarded, first->answer.pair));
}

/// What the trajectory comes to: what stops, or that it is free.
std::string decisions(const GuardedTrajectory& guarded) {
  const ReplaySummary summary = summary_of(guarded.answers);
  const auto first = [&](Verdict verdict, const char* what) {
    return first_decision(guarded, summary, static_cast<std::size_t>(verdict), what);
  };
  const std::string bad =
      first(Verdict::stop, "Stops at") + first(Verdict::not_yet_known, "Not yet known at") +
      first_decision(guarded, summary, kRefusedKind, "Firmware refuses the values of") +
      motion_decision(guarded);
  return (bad.empty()
              ? decision("v0", "Free",
                         concat(counted(guarded.answers.size(), "period", "periods"), ", ",
                                counted(guarded.robot.pair_count, "pair", "pairs"), " guarded, ",
                                grouped(guarded.unguarded.size()), " not looked at"))
              : bad) +
         unguarded_decisions(guarded.model, guarded.unguarded) + first(Verdict::warn, "Warns at");
}

std::string counts(const GuardedTrajectory& guarded) {
  const ReplaySummary summary = summary_of(guarded.answers);
  std::string items;
  for (const std::size_t kind : kKindsInOrder) {
    items += fact(kKindNames[kind], grouped(summary.periods[kind]),
                  kind == 0 || summary.periods[kind] == 0
                      ? ""
                      : concat("first at line ", guarded.trajectory.line(summary.first[kind])));
  }
  return section(
      "", "Periods",
      facts(items + fact("work a period", grouped(summary.most),
                         concat("at most; ", fixed(summary.mean, 1), " on average, ",
                                grouped(summary.percentile_999), " at the 99.9th percentile, ",
                                grouped(summary.priming), " to prime"))));
}

std::string closest_section(const GuardedTrajectory& guarded) {
  const auto closest = closest_moment(guarded.robot, guarded.trajectory);
  if (!closest) {
    return "";
  }
  const double metres = metres_of(guarded, closest->clearance.lower);
  const RobotPair& links = guarded.robot.pairs[closest->pair];
  const float* const values = guarded.trajectory.values(closest->period);
  return section(
      "",
      concat("Closest at line ", guarded.trajectory.line(closest->period), ": ",
             pair_name(guarded, closest->pair),
             metres == 0 ? " intersect" : ", " + significant(metres, 4) + " m"),
      pair_pictures(
          {guarded.model, guarded.robot, link_poses(guarded.robot, values)},
          {links.a, links.b, closest->clearance.triangles, "the triangles that are nearest"}) +
          note("Joints: <code>" +
               joint_values(guarded.model, {values, values + guarded.trajectory.variables()}) +
               "</code>"));
}

}  // namespace

std::string pair_name(const GuardedTrajectory& guarded, std::size_t pair) {
  return links_of(guarded.model, guarded.robot.pairs[pair].a, guarded.robot.pairs[pair].b);
}

double metres_of(const GuardedTrajectory& guarded, std::uint32_t fine) {
  return fine * cell_of(guarded.robot) / kFineOne;
}

std::string guard_page(const GuardedTrajectory& guarded) {
  std::string html = decision_section("What it comes to", decisions(guarded)) + counts(guarded);
  if (guarded.robot.pair_count != 0) {
    const std::vector<NearPair> near =
        near_pairs(guarded.robot, guarded.trajectory, guarded.answers);
    html += chart_section(guarded, near) + near_section(guarded, near) + closest_section(guarded);
  }
  return page(escaped(guarded.model.name), "guard", "a trajectory, as firmware&#39;s guard sees it",
              "", html + motion_section(guarded) + footer());
}

}  // namespace flashbvh::tool
