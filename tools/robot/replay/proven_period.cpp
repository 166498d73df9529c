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

/// None if the proof does not hold of a tree.
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

std::optional<ProvenPeriod> proven_period(const std::string& core, const Robot& robot) {
  const std::optional<GuardSize> size = size_of(robot);
  for (const CoreCosts& known : kCores) {
    if (size && core == known.core) {
      return ProvenPeriod{known.costs, *size};
    }
  }
  return std::nullopt;
}

}  // namespace flashbvh::tool
