// The page of flashbvh guard: the robot on its way, with the guard's verdicts.
#include <algorithm>
#include <array>
#include <utility>

#include "cli/page.hpp"
#include "cli/robot/guard_output.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// The largest number of periods that a page plays: it skips periods of longer trajectories.
constexpr std::size_t kMostPlayed = 4000;

/// The robot, and of each few periods the worst one.
Json drawn_periods(const GuardedTrajectory& guarded) {
  const Trajectory& trajectory = guarded.trajectory;
  const std::size_t step = (trajectory.size() + kMostPlayed - 1) / kMostPlayed;
  std::vector<float> all_values;
  std::string verdicts;
  Json names = Json::array();
  for (std::size_t first = 0; first < trajectory.size(); first += step) {
    const auto begin = guarded.answers.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(step, trajectory.size() - first));
    const auto worst = std::max_element(begin, end, [](const GuardAnswer& p, const GuardAnswer& q) {
      return p.verdict < q.verdict;
    });
    const auto period = static_cast<std::size_t>(worst - guarded.answers.begin());
    const float* const values = trajectory.values(period);
    all_values.insert(all_values.end(), values, values + trajectory.variables);
    verdicts += static_cast<char>('0' + static_cast<int>(worst->verdict));
    const std::string line = concat("line ", trajectory.lines[period]);
    names.push_back(!trajectory.times.empty()
                        ? concat(line, " (", shortest(trajectory.times[period]), ")")
                        : line);
  }
  return {{"image", base64(guarded.file->bytes(), guarded.file->header().byte_count)},
          {"zones", Json::array()},
          {"values", base64(all_values.data(), all_values.size() * sizeof(float))},
          {"verdicts", std::move(verdicts)},
          {"names", std::move(names)}};
}

/// What to do about the worst verdict.
constexpr std::array<const char*, kPeriodKinds> kAdvice = {
    "Run it",
    "Look where links come near before it runs",
    "Begin farther from a stop",
    "Give the guard more --work",
    "Change the motion",
    "Correct the values"};

/// A line for each verdict that occurs, refused ones and stops first, with what to do about the
/// first; motions; what is not guarded.
std::vector<Headline> headlines_of(const GuardedTrajectory& guarded) {
  const ReplaySummary summary = summary_of(guarded.answers);
  const auto& motions = guarded.motions;
  const auto bad = std::count_if(motions.begin(), motions.end(),
                                 [](const CertifiedMotion& motion) { return !is_free(motion); });
  std::vector<Headline> lines;
  for (std::size_t kind = kPeriodKinds; kind-- > 0;) {
    if (kind == 3 && bad != 0) {
      lines.push_back(
          {4, concat("motions from line to line: ", bad, " of ", motions.size(), " not free")});
    }
    if (summary.periods[kind] != 0) {
      lines.push_back(
          {static_cast<int>(kind),
           concat(kKindNames[kind], ": ", summary.periods[kind], " of ", guarded.answers.size(),
                  " periods", kind == 0 ? "" : ", " + first_of(guarded, summary, kind))});
    }
  }
  lines.front().second =
      concat(kAdvice[static_cast<std::size_t>(lines.front().first)], "; ", lines.front().second);
  add_unguarded(guarded.model, guarded.file->unguarded(), lines);
  return lines;
}

}  // namespace

std::string guard_page(const GuardedTrajectory& guarded) {
  return page_text("guard", guarded.model.name, headlines_of(guarded),
                   Json::array({guarded_facts(guarded)}), drawn_periods(guarded));
}

}  // namespace flashbvh::tool
