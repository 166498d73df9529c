// Worst-case time of queries, for static_assert: lib/docs/bounded_time.md has the proof.
//
//     constexpr uint32_t kWork =
//         flashbvh::work_within(56000, flashbvh::kCortexM4F, arm_TREE_SIZE, cell_TREE_SIZE);
//     step = query.run(kWork, found);  // 56,000 instructions at most
//
// In cycles, for a core whose manual states them, in RAM or in flash with a number of wait states:
//
//     flashbvh::work_within(84000, flashbvh::kCortexM4FCycles, 0, arm_TREE_SIZE, cell_TREE_SIZE);
#ifndef FLASHBVH_TIME_BOUND_HPP
#define FLASHBVH_TIME_BOUND_HPP

#include <stdint.h>

#include "flashbvh/detail/walk/work.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/plain/core_costs.h"
#include "flashbvh/plain/core_cycles.h"
#include "flashbvh/plain/results.h"

namespace flashbvh {

using RunCosts = flashbvh_run_costs;
using RunCycles = flashbvh_run_cycles;

/// Defines kCortexM0 to kRV32IMAC.
#define FLASHBVH_CONSTANT(core, c_name, text, ...) constexpr RunCosts k##core = {__VA_ARGS__};
FLASHBVH_FOR_EACH_CORE(FLASHBVH_CONSTANT)
#undef FLASHBVH_CONSTANT
/// Defines kCortexM0Cycles to kCortexM4FCycles. "Fast" is for parts whose MULS takes one cycle, as
/// on nearly all.
#define FLASHBVH_CONSTANT(core, c_name, text, ...) \
  constexpr RunCycles k##core##Cycles = {__VA_ARGS__};
FLASHBVH_FOR_EACH_CORE_IN_CYCLES(FLASHBVH_CONSTANT)
#undef FLASHBVH_CONSTANT

namespace detail {

constexpr uint64_t greater_of(uint64_t u, uint64_t v) {
  return u < v ? v : u;
}

constexpr uint64_t most_leaf_triangles(const TreeSize& a, const TreeSize& b) {
  return greater_of(a.leaf_size, b.leaf_size);
}

/// Returns the largest number of siblings after a node, in both trees together.
constexpr uint64_t later_siblings(const TreeSize& a, const TreeSize& b) {
  return greater_of(a.arity, 1) + greater_of(b.arity, 1) - 2;
}

}  // namespace detail

/// Returns the most visits of a whole query by any traversal, at any pose, on two meshes with these
/// numbers of leaves. Nodes must have two children or more, as `flashbvh bake` makes them. For two
/// images and `ranked`, `flashbvh collide --bound` prints the exact, lower number.
constexpr uint64_t most_visits(uint32_t leaves_a, uint32_t leaves_b) {
  return 2 * static_cast<uint64_t>(leaves_a) * leaves_b - 1;
}

/// Returns the most work of a whole query in one run: all boxes overlap, and all pairs of triangles
/// are tested. `shapes`: the number of times that a leaf's planes are prepared.
constexpr uint64_t most_work(const TreeSize& a, const TreeSize& b, uint64_t visits,
                             uint64_t shapes) {
  const uint64_t shape = detail::kShapeWork - 1 + detail::most_leaf_triangles(a, b);
  const uint64_t work = (1 + detail::kGoOnWork) * visits + shapes * shape +
                        uint64_t{detail::kTrianglePairWork} * a.triangle_count * b.triangle_count;
  return work + work / UINT16_MAX * detail::kTrianglePairWork;
}
/// For any traversal except `leaf`: one visit prepares a leaf, and two or more visits are below it.
constexpr uint64_t most_work(const TreeSize& a, const TreeSize& b) {
  const uint64_t visits = most_visits(a.leaf_count, b.leaf_count);
  return most_work(a, b, visits, visits / 3);
}

/// Returns the most work of one step: a run may overdraw by that, less 1.
constexpr uint64_t largest_step(const TreeSize& a, const TreeSize& b) {
  return detail::greater_of(detail::kTrianglePairWork,
                            detail::kShapeWork + detail::most_leaf_triangles(a, b));
}

/// Returns the most instructions of a unit of work.
constexpr uint64_t instructions_of_work(const RunCosts& costs, const TreeSize& a,
                                        const TreeSize& b) {
  // In the worst case, each pair of triangles starts a walk again.
  const uint64_t siblings = detail::later_siblings(a, b) * costs.later_sibling;
  return costs.work + (siblings + detail::kTrianglePairWork - 1) / detail::kTrianglePairWork;
}

/// Returns the most instructions of a run in addition to those of its work.
constexpr uint64_t instructions_of_start(const RunCosts& costs, const TreeSize& a,
                                         const TreeSize& b) {
  return costs.start + (uint64_t{a.depth} + b.depth) * costs.ascent +
         detail::later_siblings(a, b) * costs.later_sibling +
         (detail::most_leaf_triangles(a, b) - 1) * costs.leaf_triangle;
}

/// Returns the most instructions of PairQuery::run(work, found), from call to return, at any pose
/// and cursor. Not valid for UINT32_MAX, which is no limit.
constexpr uint64_t most_instructions(const RunCosts& costs, const TreeSize& a, const TreeSize& b,
                                     uint32_t work) {
  return instructions_of_start(costs, a, b) +
         (work + largest_step(a, b) - 1) * instructions_of_work(costs, a, b);
}

/// For SelfQuery::run(work, found), whose ascents may pass all siblings.
constexpr uint64_t most_instructions(const RunCosts& costs, const TreeSize& mesh, uint32_t work) {
  const uint64_t passed = (detail::later_siblings(mesh, mesh) + 1) * costs.later_sibling;
  return instructions_of_start(costs, mesh, mesh) + 2 * uint64_t{mesh.depth} * passed +
         (uint64_t{work} + detail::kTrianglePairWork - 1) * (costs.work + passed);
}

/// Returns the costs in cycles if each read of flash takes this many wait states.
constexpr RunCosts costs_in_cycles(const RunCycles& core, uint32_t wait_states) {
  const RunCosts& cycles = core.cycles;
  const RunCosts& reads = core.reads;
  return {cycles.start + wait_states * reads.start, cycles.ascent + wait_states * reads.ascent,
          cycles.later_sibling + wait_states * reads.later_sibling,
          cycles.leaf_triangle + wait_states * reads.leaf_triangle,
          cycles.work + wait_states * reads.work};
}

/// As most_instructions(), in cycles. `wait_states`: at most 1000, for each read of the memory of
/// code and meshes; 0 for RAM. Assumes no cache hits.
constexpr uint64_t most_cycles(const RunCycles& core, uint32_t wait_states, const TreeSize& a,
                               const TreeSize& b, uint32_t work) {
  return most_instructions(costs_in_cycles(core, wait_states), a, b, work);
}
/// For a mesh against itself.
constexpr uint64_t most_cycles(const RunCycles& core, uint32_t wait_states, const TreeSize& mesh,
                               uint32_t work) {
  return most_instructions(costs_in_cycles(core, wait_states), mesh, work);
}

namespace detail {

/// `none`: the most that a run without work takes.
constexpr uint32_t work_within(uint64_t instructions, uint64_t none, uint64_t of_work) {
  const uint64_t work = instructions < none ? 0 : (instructions - none) / of_work;
  return work < kUnlimited ? static_cast<uint32_t>(work) : kUnlimited - 1;
}

}  // namespace detail

/// Returns the most work with which run(work, found) takes at most this many instructions; 0 if
/// there is none, and never UINT32_MAX.
constexpr uint32_t work_within(uint64_t instructions, const RunCosts& costs, const TreeSize& a,
                               const TreeSize& b) {
  return detail::work_within(instructions, most_instructions(costs, a, b, 0),
                             instructions_of_work(costs, a, b));
}
/// For a mesh against itself.
constexpr uint32_t work_within(uint64_t instructions, const RunCosts& costs, const TreeSize& mesh) {
  const uint64_t none = most_instructions(costs, mesh, 0);
  return detail::work_within(instructions, none, most_instructions(costs, mesh, 1) - none);
}

/// Returns the most work with which run(work, found) takes at most this many cycles; arguments as
/// for most_cycles().
constexpr uint32_t work_within(uint64_t cycles, const RunCycles& core, uint32_t wait_states,
                               const TreeSize& a, const TreeSize& b) {
  return work_within(cycles, costs_in_cycles(core, wait_states), a, b);
}
/// For a mesh against itself.
constexpr uint32_t work_within(uint64_t cycles, const RunCycles& core, uint32_t wait_states,
                               const TreeSize& mesh) {
  return work_within(cycles, costs_in_cycles(core, wait_states), mesh);
}

}  // namespace flashbvh

#endif
