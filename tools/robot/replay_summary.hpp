// What a replayed trajectory comes to.
#ifndef FLASHBVH_TOOLS_ROBOT_REPLAY_SUMMARY_HPP
#define FLASHBVH_TOOLS_ROBOT_REPLAY_SUMMARY_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robot/replay.hpp"

namespace flashbvh::tool {

/// Those of Verdict, and values that are refused.
constexpr std::size_t kPeriodKinds = 5;
constexpr std::size_t kRefusedKind = 4;
/// As they are told, from the best to the worst.
constexpr std::array<std::size_t, kPeriodKinds> kKindsInOrder = {0, 1, 3, 2, 4};
constexpr std::array<const char*, kPeriodKinds> kKindNames = {"free", "warn", "not yet known",
                                                              "stop", "refused"};
std::size_t kind_of(const GuardAnswer& answer);
/// "free", "hit", "close".
const char* outcome_name(MotionOutcome outcome);
bool is_free(const CertifiedMotion& motion);

struct ReplaySummary {
  std::array<std::size_t, kPeriodKinds> periods{};
  std::array<std::size_t, kPeriodKinds> first{};  ///< the first of them
  bool is_primed = false;                         ///< else there is no work
  std::uint32_t priming = 0;
  double mean = 0;  ///< work of the periods after the one that primed
  std::uint32_t percentile_999 = 0;
  std::uint32_t most = 0;
};

ReplaySummary summary_of(const std::vector<GuardAnswer>& answers);

}  // namespace flashbvh::tool

#endif
