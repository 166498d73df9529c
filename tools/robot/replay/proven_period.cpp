#include "robot/replay/proven_period.hpp"

#include <algorithm>

#include "flashbvh/detail/lattice/image_parts.hpp"
#include "robot/replay/replay.hpp"

namespace flashbvh::tool {
namespace {

struct CoreCosts {
  const char* core;
  GuardCosts costs;
};

#define FLASHBVH_CORE_OF(core, c_name, text, ...) {text, kGuardOn##core},
constexpr CoreCosts kCores[] = {FLASHBVH_FOR_EACH_GUARD_CORE(FLASHBVH_CORE_OF)};
#undef FLASHBVH_CORE_OF

/// None if no cycles are proven.
std::optional<GuardCosts> guard_cycles_on(const std::string& core, std::uint32_t wait_states) {
#define FLASHBVH_CORE_OF(name, c_name, text, ...)                 \
  if (core == (text)) {                                           \
    return detail::with_waits(kGuardCyclesOn##name, wait_states); \
  }
  FLASHBVH_FOR_EACH_GUARD_CORE_IN_CYCLES(FLASHBVH_CORE_OF)
#undef FLASHBVH_CORE_OF
  return std::nullopt;
}

/// None if the proof does not cover one of the trees.
std::optional<GuardSize> size_of(const Robot& robot) {
  std::uint32_t depth = 0;
  std::uint32_t leaf_size = 0;
  for (std::uint32_t i = 0; i < robot.link_count; ++i) {
    detail::TreeShape shape{};
    if (detail::check_tree(robot.meshes[i], detail::ImageLevels<std::uint16_t>{}, shape) !=
            Status::done ||
        shape.arity > kMostBoundedArity) {
      return std::nullopt;
    }
    depth = std::max(depth, shape.depth);
    leaf_size = std::max(leaf_size, shape.leaf_size);
  }
  if (leaf_size > kMostBoundedLeaf) {
    return std::nullopt;
  }
  return guard_size_of(robot, 2 * depth, leaf_size);
}

}  // namespace

std::optional<std::uint64_t> ProvenPeriod::most(std::uint32_t work) const {
  return work >= kAllWork ? std::nullopt : std::make_optional(most_instructions(costs, size, work));
}

std::optional<std::uint64_t> ProvenPeriod::most_cycles(std::uint32_t work) const {
  return cycles && work < kAllWork ? std::make_optional(most_instructions(*cycles, size, work))
                                   : std::nullopt;
}

std::optional<ProvenPeriod> proven_period(const std::string& core, std::uint32_t wait_states,
                                          const Robot& robot) {
  const std::optional<GuardSize> size = size_of(robot);
  for (const CoreCosts& known : kCores) {
    if (size && core == known.core) {
      return ProvenPeriod{known.costs, *size, guard_cycles_on(core, wait_states)};
    }
  }
  return std::nullopt;
}

}  // namespace flashbvh::tool
