// Worst-case time of a guard's periods, for static_assert: lib/docs/bounded_time.md has the proof.
//
//     constexpr flashbvh::GuardSize kArm = {6, 15, 62, 4, 20, 2};
//     static_assert(flashbvh::most_instructions(flashbvh::kGuardOnCortexM4F, kArm, 100) < 2000000);
//     constexpr flashbvh::GuardCycles kM4F = flashbvh::kGuardCyclesOnCortexM4F;
//     static_assert(flashbvh::most_cycles(kM4F, 0, kArm, 100) < 3000000);
#ifndef FLASHBVH_ROBOT_PERIOD_BOUND_HPP
#define FLASHBVH_ROBOT_PERIOD_BOUND_HPP

#include <stdint.h>

#include "flashbvh/detail/walk/work.hpp"
#include "flashbvh/plain/core_costs.h"
#include "flashbvh/plain/core_cycles.h"
#include "flashbvh/robot/robot.hpp"

namespace flashbvh {

/// The most instructions of the parts of a guard's period on one core, with GCC 12 at -O2.
struct GuardCosts {
  uint32_t start;    ///< once
  uint32_t joint;    ///< kinematics of a joint
  uint32_t turn;     ///< an iteration of a loop over joints or pairs that does almost nothing
  uint32_t pair;     ///< a test of a pair's certificate
  uint32_t between;  ///< a joint between two links, each test
  uint32_t table;    ///< a pair's or an axis's part in a lookup in a distance table
  uint32_t measure;  ///< a measured pair, beyond what its work pays for
  uint32_t ascent;   ///< once for each level of two trees
  uint32_t within;   ///< an exact test of two triangles
  uint32_t work;     ///< each unit of work
};

/// Defines kGuardOnCortexM0 to kGuardOnRV32IMAC.
#define FLASHBVH_CONSTANT(core, c_name, text, ...) \
  constexpr GuardCosts kGuardOn##core = {__VA_ARGS__};
FLASHBVH_FOR_EACH_GUARD_CORE(FLASHBVH_CONSTANT)
#undef FLASHBVH_CONSTANT

/// The most cycles of these parts.
struct GuardCycles {
  GuardCosts cycles;  ///< in memory without wait states
  GuardCosts reads;   ///< reads of flash, each of which takes its wait states
};

/// Defines kGuardCyclesOnCortexM0 to kGuardCyclesOnCortexM4F, as RunCycles.
#define FLASHBVH_CONSTANT(core, c_name, text, ...) \
  constexpr GuardCycles kGuardCyclesOn##core = {__VA_ARGS__};
FLASHBVH_FOR_EACH_GUARD_CORE_IN_CYCLES(FLASHBVH_CONSTANT)
#undef FLASHBVH_CONSTANT

/// The properties of a robot that bound a period. No node may have more than kMostBoundedArity
/// children, as `flashbvh robot` bakes trees.
struct GuardSize {
  uint32_t joints;
  uint32_t pairs;
  uint32_t pair_joints;   ///< sum over all pairs of the joints between their links
  uint32_t tabled_pairs;  ///< pairs with one or two joints between their links
  uint32_t depth;         ///< sum of the depths of the two deepest trees
  uint32_t leaf_size;     ///< triangles in the largest leaf, at most kMostBoundedLeaf
};

constexpr uint32_t kMostBoundedArity = 4;
/// The bound does not cover runs that resume inside larger leaves.
constexpr uint32_t kMostBoundedLeaf = 7;

/// `depth`, `leaf_size`: as in GuardSize.
constexpr GuardSize guard_size_of(const Robot& robot, uint32_t depth, uint32_t leaf_size) {
  GuardSize size = {robot.joint_count, robot.pair_count, 0, 0, depth, leaf_size};
  for (uint32_t i = 0; i < robot.pair_count; ++i) {
    const uint32_t between = robot.pairs[i].joints_a + robot.pairs[i].joints_b;
    size.pair_joints += between;
    size.tabled_pairs += between == 1 || between == 2 ? 1 : 0;
  }
  return size;
}

/// Returns the costs in cycles if each read of flash takes this many wait states.
constexpr GuardCosts costs_in_cycles(const GuardCycles& core, uint32_t wait_states) {
  const auto cost = [&](uint32_t GuardCosts::*of) {
    return core.cycles.*of + wait_states * core.reads.*of;
  };
  return {cost(&GuardCosts::start),   cost(&GuardCosts::joint),   cost(&GuardCosts::turn),
          cost(&GuardCosts::pair),    cost(&GuardCosts::between), cost(&GuardCosts::table),
          cost(&GuardCosts::measure), cost(&GuardCosts::ascent),  cost(&GuardCosts::within),
          cost(&GuardCosts::work)};
}

namespace detail {

/// The least work before the measurement of a witness that is nearer than the limit.
constexpr uint32_t kNearerWork = kAlongPairWork + kPlacedPairWork + kExactPairWork + kAimWork;
/// The most pairs of leaves whose tests a period may overdraw.
constexpr uint32_t kBatchedLeafPairs = 4;

/// A test of all pairs, each with a lookup in its distance table.
constexpr uint64_t instructions_of_look(const GuardCosts& costs, const GuardSize& size) {
  const uint64_t turns = size.joints + uint64_t{size.pairs} * size.joints;
  const uint64_t tables = uint64_t{size.tabled_pairs} * 2 * (size.pairs + size.tabled_pairs + 2);
  return uint64_t{size.pairs} * costs.pair + uint64_t{size.pair_joints} * costs.between +
         turns * costs.turn + tables * costs.table;
}

}  // namespace detail

/// Returns the most instructions of Guard::update(values, work), from call to return, for any
/// values, a checked robot and any state that Guard::resume() takes. Not valid for UINT32_MAX,
/// which is no limit.
constexpr uint64_t most_instructions(const GuardCosts& costs, const GuardSize& size,
                                     uint32_t work) {
  const uint64_t begun = (uint64_t{work} + detail::kPoseWork - 1) / detail::kPoseWork;
  const uint64_t measured = begun < size.pairs ? begun : size.pairs;
  const uint64_t joints = size.joints;
  const uint64_t around =
      (6 * uint64_t{size.pairs} + 2 * joints) * costs.turn + 2 * joints * costs.between;
  const uint64_t of_work =
      costs.work +
      (joints * costs.between + uint64_t{size.pairs} * costs.turn + detail::kNearerWork - 1) /
          detail::kNearerWork;
  return costs.start + joints * (costs.joint + joints * costs.turn) +
         (measured + 2) * detail::instructions_of_look(costs, size) + measured * costs.measure +
         (measured + 1) * around + uint64_t{size.depth} * costs.ascent +
         uint64_t{detail::kBatchedLeafPairs} * size.leaf_size * size.leaf_size * costs.within +
         (uint64_t{work} + detail::kPoseWork + detail::kAimWork + joints - 1) * of_work;
}

/// As most_instructions(), in cycles. `wait_states`: at most 1000, for each read of the memory of
/// code and robot; 0 for RAM. Assumes no cache hits.
constexpr uint64_t most_cycles(const GuardCycles& core, uint32_t wait_states, const GuardSize& size,
                               uint32_t work) {
  return most_instructions(costs_in_cycles(core, wait_states), size, work);
}

/// Returns the most work with which a period takes at most this many instructions; 0 if there is
/// none, and never UINT32_MAX.
constexpr uint32_t work_within(uint64_t instructions, const GuardCosts& costs,
                               const GuardSize& size) {
  uint32_t work = 0;
  for (uint32_t bit = uint32_t{1} << 31; bit != 0; bit >>= 1) {
    const uint32_t more = work | bit;
    work = more != UINT32_MAX && most_instructions(costs, size, more) <= instructions ? more : work;
  }
  return work;
}
/// Within this many cycles; arguments as for most_cycles().
constexpr uint32_t work_within(uint64_t cycles, const GuardCycles& core, uint32_t wait_states,
                               const GuardSize& size) {
  return work_within(cycles, costs_in_cycles(core, wait_states), size);
}

}  // namespace flashbvh

#endif
