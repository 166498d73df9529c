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

  /// Instructions; none without a limit of work.
  std::optional<std::uint64_t> most(std::uint32_t work) const;
};

/// None of a robot with leaves or nodes beyond kMostBoundedLeaf or kMostBoundedArity. `core`:
/// "Cortex-M4F".
std::optional<ProvenPeriod> proven_period(const std::string& core, const Robot& robot);

}  // namespace flashbvh::tool
