// Proven bounds of a guard's period on each core (flashbvh/robot/period_bound.hpp);
// period_costs.hpp has estimates.
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
  std::optional<GuardCosts> cycles = {};  ///< in cycles, wait states included; none for some cores

  /// In instructions; none without a limit of work.
  std::optional<std::uint64_t> most(std::uint32_t work) const;
  /// None, too, if the core's cycles are not proven.
  std::optional<std::uint64_t> most_cycles(std::uint32_t work) const;
};

/// None for a robot with leaves or nodes beyond kMostBoundedLeaf or kMostBoundedArity. `core`:
/// "Cortex-M4F"; `wait_states`: per read of flash.
std::optional<ProvenPeriod> proven_period(const std::string& core, std::uint32_t wait_states,
                                          const Robot& robot);

}  // namespace flashbvh::tool
