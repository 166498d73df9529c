// What a guard's periods take on a core at most: proven of each core
// (flashbvh/robot/period_bound.hpp), where period_costs.hpp has estimates.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "flashbvh/robot/period_bound.hpp"

namespace flashbvh::tool {

/// A robot's guard on a core.
struct ProvenPeriod {
  GuardCosts costs;
  GuardSize size;
  std::optional<GuardCosts> cycles = {};  ///< in cycles, wait states included; none of some cores

  /// Instructions; none without a limit of work.
  std::optional<std::uint64_t> most(std::uint32_t work) const;
  /// None of cores whose cycles are not proven, too.
  std::optional<std::uint64_t> most_cycles(std::uint32_t work) const;
};

/// None of a robot with leaves or nodes beyond kMostBoundedLeaf or kMostBoundedArity. `core`:
/// "Cortex-M4F"; `wait_states`: of each read of flash.
std::optional<ProvenPeriod> proven_period(const std::string& core, std::uint32_t wait_states,
                                          const Robot& robot);

}  // namespace flashbvh::tool
