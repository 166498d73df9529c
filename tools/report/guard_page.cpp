#include "report/guard_page.hpp"

#include <algorithm>
#include <cmath>

#include "live/live_section.hpp"
#include "report/html.hpp"
#include "report/links.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Stretches in the list; the page counts the others.
constexpr std::size_t kMostStretches = 200;

/// Indices of verdicts in NearPair::named.
constexpr std::size_t kWarn = static_cast<std::size_t>(Verdict::warn);
constexpr std::size_t kUnknown = static_cast<std::size_t>(Verdict::not_yet_known);
constexpr std::size_t kStop = static_cast<std::size_t>(Verdict::stop);

std::string metres_or_none(const GuardedTrajectory& guarded, std::optional<std::uint32_t> fine) {
  return fine ? significant(metres_of(guarded, *fine), 4) : "&ndash;";
}

std::string pairs_table(const GuardedTrajectory& guarded, const std::vector<NearPair>& near) {
  std::vector<Cells> rows;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const NearPair& pair = near[i];
    rows.push_back({pair_name(guarded, pair.pair), i < kMostLines ? concat(i + 1) : "&ndash;",
                    grouped(pair.named[kStop]), grouped(pair.named[kUnknown]),
                    grouped(pair.named[kWarn]), grouped(pair.within_stop),
                    grouped(pair.within_warn), metres_or_none(guarded, pair.closest),
                    pair.closest ? concat(guarded.trajectory.line(pair.closest_period)) : ""});
  }
  return table("Pairs that stop, are not yet known or are warned of",
               {"links", "#drawn as", "#stop", "#not yet known", "#warn", "#lines within stop",
                "#within warn", "#closest, m", "#at line"},
               rows) +
         note(
             "Stop and warn count periods of a guard of the pair alone, with all the work it "
             "takes; "
             "lines are counted as the meshes are measured there.");
}

/// "9", or with its time "9 (0.35)".
std::string line_cell(const Trajectory& trajectory, std::size_t period) {
  const std::string line = concat(trajectory.line(period));
  return trajectory.has_times() ? concat(line, " (", shortest(trajectory.time(period)), ")") : line;
}

/// The largest number of periods that a page plays: it skips periods of longer trajectories.
constexpr std::size_t kMostPlayed = 4000;

/// Periods of the trajectory per played period, which is the worst of them.
std::size_t periods_a_step(const Trajectory& trajectory) {
  return (trajectory.size() + kMostPlayed - 1) / kMostPlayed;
}

LivePeriods played_periods(const GuardedTrajectory& guarded) {
  const Trajectory& trajectory = guarded.trajectory;
  const std::size_t step = periods_a_step(trajectory);
  LivePeriods played;
  for (std::size_t first = 0; first < trajectory.size(); first += step) {
    const auto begin = guarded.answers.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(step, trajectory.size() - first));
    const auto worst = std::max_element(begin, end, [](const GuardAnswer& p, const GuardAnswer& q) {
      return p.verdict < q.verdict;
    });
    const auto period = static_cast<std::size_t>(worst - guarded.answers.begin());
    const float* const values = trajectory.values(period);
    played.values.insert(played.values.end(), values, values + trajectory.variables());
    played.verdicts += static_cast<char>('0' + static_cast<int>(worst->verdict));
    played.names.push_back("line " + line_cell(trajectory, period));
  }
  return played;
}

/// A line in a table; choosing it shows the robot there.
std::string shown_line(const Trajectory& trajectory, std::size_t period) {
  return concat("<span data-period=", period / periods_a_step(trajectory), ">",
                line_cell(trajectory, period), "</span>");
}

std::string stretches_table(const GuardedTrajectory& guarded) {
  const std::vector<Stretch> all = stretches_of(guarded.robot, guarded.trajectory, guarded.answers);
  std::vector<Cells> rows;
  for (const Stretch& stretch : worst_of(all, kMostStretches)) {
    const bool is_refused = stretch.pair == kNoPair;
    rows.push_back({shown_line(guarded.trajectory, stretch.first),
                    shown_line(guarded.trajectory, stretch.last),
                    square(concat("v", stretch.kind)) + kKindNames[stretch.kind],
                    is_refused ? "" : pair_name(guarded, stretch.pair),
                    is_refused ? "" : significant(metres_of(guarded, stretch.kept), 4),
                    is_refused ? "" : metres_or_none(guarded, stretch.closest)});
  }
  const std::string of_line =
      guarded.trajectory.has_times() ? " (" + escaped(guarded.trajectory.time_name()) + ")" : "";
  return table("Stretches that are not free",
               {"from line" + of_line, "to line" + of_line, "verdict", "links", "#known, m",
                "#closest at a line, m"},
               rows) +
         (rows.size() == all.size() ? ""
                                    : note("And " + grouped(all.size() - rows.size()) +
                                           " more, shorter or less bad: --json has a line each."));
}

/// Rows in the table; the page counts the others.
constexpr std::size_t kMostRows = 200;

Cells row_of(const GuardedTrajectory& guarded, std::size_t first, std::size_t last) {
  const CertifiedMotion& motion = guarded.motions[first];
  const std::string lines =
      concat(guarded.trajectory.line(first), " to ", guarded.trajectory.line(last + 1));
  if (motion.answer.status != Status::done) {
    return {lines, "refused", "", "", ""};
  }
  const char* const outcome = outcome_name(motion.answer.outcome);
  return is_free(motion) ? Cells{lines, outcome, "", "", ""}
                         : Cells{lines, outcome, pair_name(guarded, motion.answer.pair),
                                 significant(motion.part, 4),
                                 "<code>" + joint_values(guarded.model, motion.values) + "</code>"};
}

/// "Stops at line 3": the first period of a kind, its pair, and the number of such periods.
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

/// The result of the trajectory: what is not free, the worst first, or that all is free.
std::string decisions(const GuardedTrajectory& guarded) {
  const ReplaySummary summary = summary_of(guarded.answers);
  const auto first = [&](Verdict verdict, const char* what) {
    return first_decision(guarded, summary, static_cast<std::size_t>(verdict), what);
  };
  const std::string bad =
      first(Verdict::stop, "Stops at") + first(Verdict::not_yet_known, "Not yet known at") +
      first_decision(guarded, summary, kRefusedKind, "Firmware refuses the values of") +
      motion_decision(guarded) + first(Verdict::warn, "Warns at");
  return (bad.empty()
              ? decision("v0", "Free",
                         concat(counted(guarded.answers.size(), "period", "periods"), ", ",
                                counted(guarded.robot.pair_count, "pair", "pairs"), " guarded, ",
                                grouped(guarded.unguarded.size()), " not looked at"))
              : bad) +
         unguarded_decisions(guarded.model, guarded.unguarded);
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

std::string cost_cell(const GuardTiming& timing, double instructions,
                      std::optional<std::uint64_t> cycles = {}) {
  return cost_text(timing, instructions, cycles, [](double number) {
    return grouped(static_cast<std::uint64_t>(std::llround(number)));
  });
}

/// The section of times on a core; empty if no core is given.
std::string time_section(const GuardedTrajectory& guarded) {
  if (!guarded.timing) {
    return "";
  }
  const GuardTiming& timing = *guarded.timing;
  std::vector<Cells> rows;
  for (std::size_t i = 0; i < kQuantileNames.size(); ++i) {
    rows.push_back({concat(kQuantileNames[i], " %"), cost_cell(timing, timing.replayed[i]),
                    timing.least ? cost_cell(timing, timing.of_least[i]) : "&ndash;"});
  }
  std::string items = fact("least work", timing.least ? grouped(timing.least->work) : "none",
                           "keeps not yet known below 0.1 % of periods");
  if (timing.clock) {
    const auto within = work_within(timing.costs, *timing.clock);
    items += fact("a period has time for", within ? grouped(*within) : "none", "work");
  }
  for (const ProvenWork& proven : proven_work(timing)) {
    items += fact(concat("proven with ", grouped(proven.work), " work"),
                  cost_cell(timing, static_cast<double>(proven.instructions), proven.cycles),
                  "instructions at most");
  }
  return section("time", "Time on a " + timing.costs.core,
                 facts(items) +
                     table(timing.clock ? "Instructions of a period, their time, and part of it"
                                        : "Instructions of a period",
                           {"of periods", "#as replayed", "#with the least work"}, rows) +
                     note(escaped(estimate_note(timing.costs))));
}

std::string closest_section(const GuardedTrajectory& guarded) {
  const auto closest = closest_moment(guarded.robot, guarded.trajectory);
  if (!closest) {
    return "";
  }
  const double metres = metres_of(guarded, closest->clearance.lower);
  const float* const at = guarded.trajectory.values(closest->period);
  const std::vector<double> values = {at, at + guarded.trajectory.variables()};
  return section("",
                 concat("Closest at line ", guarded.trajectory.line(closest->period), ": ",
                        pair_name(guarded, closest->pair),
                        metres == 0 ? " intersect" : ", " + significant(metres, 4) + " m"),
                 concat("<p", shown_values(values), ">Joints: <code>",
                        joint_values(guarded.model, values), "</code></p>\n"));
}

/// The section of all near pairs and of stretches that are not free; empty if there are none.
std::string near_section(const GuardedTrajectory& guarded, const std::vector<NearPair>& near) {
  const bool is_free_all = summary_of(guarded.answers).periods[0] == guarded.answers.size();
  return near.empty() && is_free_all
             ? ""
             : section("stretches", "What is not free",
                       (is_free_all ? "" : stretches_table(guarded)) +
                           (near.empty() ? "" : pairs_table(guarded, near)));
}

/// The section of motions from line to line; consecutive free motions share a row. Empty if there
/// are none.
std::string motion_section(const GuardedTrajectory& guarded) {
  const std::vector<CertifiedMotion>& motions = guarded.motions;
  std::vector<Cells> rows;
  std::size_t i = 0;
  while (i < motions.size() && rows.size() < kMostRows) {
    const std::size_t first = i++;
    while (is_free(motions[first]) && i < motions.size() && is_free(motions[i])) {
      ++i;
    }
    rows.push_back(row_of(guarded, first, i - 1));
  }
  if (rows.empty()) {
    return "";
  }
  return section("", "Motions from line to line",
                 table("Straight ways of all joints, certified",
                       {"lines", "outcome", "links", "#part of the way", "joints there"}, rows) +
                     (i == motions.size()
                          ? ""
                          : note("And " + grouped(motions.size() - i) + " more: --json has all.")));
}

}  // namespace

std::string pair_name(const GuardedTrajectory& guarded, std::size_t pair) {
  return links_of(guarded.model, guarded.robot.pairs[pair].a, guarded.robot.pairs[pair].b);
}

double metres_of(const GuardedTrajectory& guarded, std::uint32_t fine) {
  return fine * cell_of(guarded.robot) / kFineOne;
}

std::string guard_page(const GuardedTrajectory& guarded) {
  std::string html = decision_section("What it comes to", decisions(guarded)) +
                     live_section(guarded.image, {}, played_periods(guarded)) + counts(guarded) +
                     time_section(guarded);
  if (guarded.robot.pair_count != 0) {
    const std::vector<NearPair> near =
        near_pairs(guarded.robot, guarded.trajectory, guarded.answers);
    html += chart_section(guarded, near) + near_section(guarded, near) + closest_section(guarded);
  }
  return page(escaped(guarded.model.name), "guard", "a trajectory, as firmware&#39;s guard sees it",
              html + motion_section(guarded) + footer());
}

}  // namespace flashbvh::tool
