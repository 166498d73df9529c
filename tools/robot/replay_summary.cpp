#include "robot/replay_summary.hpp"

#include <algorithm>
#include <numeric>

namespace flashbvh::tool {

std::size_t kind_of(const GuardAnswer& answer) {
  return answer.status == Status::done ? static_cast<std::size_t>(answer.verdict) : kRefusedKind;
}

const char* outcome_name(MotionOutcome outcome) {
  constexpr const char* kNames[] = {"free", "hit", "close"};
  return kNames[static_cast<std::size_t>(outcome)];
}

bool is_free(const CertifiedMotion& motion) {
  return motion.answer.status == Status::done && motion.answer.outcome == MotionOutcome::free;
}

ReplaySummary summary_of(const std::vector<GuardAnswer>& answers) {
  ReplaySummary summary;
  std::vector<std::uint32_t> work;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const std::size_t kind = kind_of(answers[i]);
    if (summary.periods[kind]++ == 0) {
      summary.first[kind] = i;
    }
    if (summary.is_primed) {
      work.push_back(answers[i].work);
    } else if (kind != kRefusedKind) {
      summary.is_primed = true;
      summary.priming = answers[i].work;
    }
  }
  if (!work.empty()) {
    std::sort(work.begin(), work.end());
    summary.mean =
        std::accumulate(work.begin(), work.end(), 0.0) / static_cast<double>(work.size());
    summary.percentile_999 = work[work.size() - 1 - work.size() / 1000];
    summary.most = work.back();
  }
  return summary;
}

}  // namespace flashbvh::tool
