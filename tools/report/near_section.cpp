#include "report/guard_page.hpp"
#include "report/html.hpp"
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
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const NearPair& pair = near[i];
    rows.push_back({pair_name(guarded, pair.pair), i < kMostLines ? concat(i + 1) : "&ndash;",
                    grouped(pair.named[kStop]), grouped(pair.named[kUnknown]),
                    grouped(pair.named[kWarn]), grouped(pair.within_stop),
                    grouped(pair.within_warn), metres_or_none(guarded, pair.closest),
                    pair.closest ? concat(guarded.trajectory.line(pair.closest_period)) : ""});
  }
  return table("Pairs that stop, are not yet known or are warned of",
               {{"links", false},
                {"drawn as", true},
                {"stop", true},
                {"not yet known", true},
                {"warn", true},
                {"lines within stop", true},
                {"within warn", true},
                {"closest, m", true},
                {"at line", true}},
               rows) +
         "<p class=note>Stop and warn count periods of a guard of the pair alone, with all the "
         "work "
         "it takes; lines are counted as the meshes are measured there.</p>\n";
}

std::string stretches_table(const GuardedTrajectory& guarded) {
  const std::vector<Stretch> all = stretches_of(guarded.robot, guarded.trajectory, guarded.answers);
  std::vector<std::vector<std::string>> rows;
  for (const Stretch& stretch : worst_of(all, kMostStretches)) {
    const bool is_refused = stretch.pair == kNoPair;
    rows.push_back(
        {concat(guarded.trajectory.line(stretch.first)),
         concat(guarded.trajectory.line(stretch.last)),
         "<i class=\"key v" + std::to_string(stretch.kind) + "\"></i>" + kKindNames[stretch.kind],
         is_refused ? "" : pair_name(guarded, stretch.pair),
         is_refused ? "" : significant(metres_of(guarded, stretch.kept), 4),
         is_refused ? "" : metres_or_none(guarded, stretch.closest)});
  }
  return table("Stretches that are not free",
               {{"from line", false},
                {"to line", false},
                {"verdict", false},
                {"links", false},
                {"known, m", true},
                {"closest at a line, m", true}},
               rows) +
         (rows.size() == all.size()
              ? ""
              : "<p class=note>And " + grouped(all.size() - rows.size()) +
                    " more, shorter or less bad: --json has a line each.</p>\n");
}

}  // namespace

std::string near_section(const GuardedTrajectory& guarded, const std::vector<NearPair>& near) {
  const bool is_free_all = summary_of(guarded.answers).periods[0] == guarded.answers.size();
  return near.empty() && is_free_all
             ? ""
             : "<section id=stretches><h2>What is not free</h2>\n" +
                   (is_free_all ? "" : stretches_table(guarded)) +
                   (near.empty() ? "" : pairs_table(guarded, near)) + "</section>\n";
}

}  // namespace flashbvh::tool
