#include "robot/replay/proven_period.hpp"

#include <algorithm>

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
#define FLASHBVH_CORE_OF(name, c_name, text, ...)              \
  if (core == (text)) {                                        \
    return costs_in_cycles(kGuardCyclesOn##name, wait_states); \
  }
  FLASHBVH_FOR_EACH_GUARD_CORE_IN_CYCLES(FLASHBVH_CORE_OF)
#undef FLASHBVH_CORE_OF
  return std::nullopt;
}

/// Adds the subtree of a node at this depth to the size.
void add_subtree(const Mesh& mesh, std::uint32_t node, std::uint32_t depth, TreeSize& size) {
  size.depth = std::max(size.depth, depth);
  if (mesh.nodes[node].is_leaf()) {
    size.leaf_size = std::max(size.leaf_size, mesh.triangles_in(mesh.nodes[node].leaf()));
    return;
  }
  std::uint32_t children = 1;
  std::uint32_t child = mesh.first_child(node);
  for (; !mesh.is_last_child(node, child); child = mesh.next_sibling(child), ++children) {
    add_subtree(mesh, child, depth + 1, size);
  }
  add_subtree(mesh, child, depth + 1, size);
  size.arity = std::max(size.arity, children);
}

/// None if the proof does not cover one of the trees.
std::optional<GuardSize> size_of(const Robot& robot) {
  TreeSize size{};
  for (std::uint32_t i = 0; i < robot.link_count; ++i) {
    add_subtree(robot.meshes[i], 0, 0, size);
  }
  if (size.arity > kMostBoundedArity || size.leaf_size > kMostBoundedLeaf) {
    return std::nullopt;
  }
  return guard_size_of(robot, 2 * size.depth, size.leaf_size);
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
