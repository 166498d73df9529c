#include "report/arm_pictures.hpp"
#include "report/guard_page.hpp"
#include "report/html.hpp"
#include "robot/replay/replay.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Stretches that are listed; more are counted.
constexpr std::size_t kMostStretches = 200;

/// A verdict's place in NearPair::named.
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

std::string stretches_table(const GuardedTrajectory& guarded) {
  const std::vector<Stretch> all = stretches_of(guarded.robot, guarded.trajectory, guarded.answers);
  std::vector<Cells> rows;
  for (const Stretch& stretch : worst_of(all, kMostStretches)) {
    const bool is_refused = stretch.pair == kNoPair;
    rows.push_back({concat(guarded.trajectory.line(stretch.first)),
                    concat(guarded.trajectory.line(stretch.last)),
                    square(concat("v", stretch.kind)) + kKindNames[stretch.kind],
                    is_refused ? "" : pair_name(guarded, stretch.pair),
                    is_refused ? "" : significant(metres_of(guarded, stretch.kept), 4),
                    is_refused ? "" : metres_or_none(guarded, stretch.closest)});
  }
  return table("Stretches that are not free",
               {"from line", "to line", "verdict", "links", "#known, m", "#closest at a line, m"},
               rows) +
         (rows.size() == all.size() ? ""
                                    : note("And " + grouped(all.size() - rows.size()) +
                                           " more, shorter or less bad: --json has a line each."));
}

/// More are counted.
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

}  // namespace

std::string near_section(const GuardedTrajectory& guarded, const std::vector<NearPair>& near) {
  const bool is_free_all = summary_of(guarded.answers).periods[0] == guarded.answers.size();
  return near.empty() && is_free_all
             ? ""
             : section("stretches", "What is not free",
                       (is_free_all ? "" : stretches_table(guarded)) +
                           (near.empty() ? "" : pairs_table(guarded, near)));
}

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

}  // namespace flashbvh::tool
