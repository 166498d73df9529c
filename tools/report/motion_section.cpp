#include "report/arm_pictures.hpp"
#include "report/guard_page.hpp"
#include "report/html.hpp"
#include "robot/replay_summary.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

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
