// What queries can cost at worst, for static_assert: lib/docs/bounded_time.md has the proof.
//
//     constexpr uint32_t kWork =
//         flashbvh::work_within(56000, flashbvh::kCortexM4F, arm_TREE_SIZE, cell_TREE_SIZE);
//     step = query.run(kWork, found);  // 56,000 instructions at most
//
// In cycles, of a core whose manual has them, in RAM or in flash with so many wait states:
//
//     flashbvh::work_within(84000, flashbvh::kCortexM4FCycles, 0, arm_TREE_SIZE, cell_TREE_SIZE);
#ifndef FLASHBVH_TIME_BOUND_HPP
#define FLASHBVH_TIME_BOUND_HPP

#include <stdint.h>

#include "flashbvh/detail/walk/work.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/plain/results.h"
#include "flashbvh/plain/run_costs.h"
#include "flashbvh/plain/run_cycles.h"

namespace flashbvh {

using RunCosts = flashbvh_run_costs;
using RunCycles = flashbvh_run_cycles;

/// kCortexM0 to kRV32IMAC.
#define FLASHBVH_CONSTANT(core, c_name, text, ...) constexpr RunCosts k##core = {__VA_ARGS__};
FLASHBVH_FOR_EACH_CORE(FLASHBVH_CONSTANT)
#undef FLASHBVH_CONSTANT
/// kCortexM0Cycles to kCortexM4FCycles. Fast: of parts whose MULS takes one cycle, as nearly all
/// do.
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

/// Siblings after a node, in both trees.
constexpr uint64_t later_siblings(const TreeSize& a, const TreeSize& b) {
  return greater_of(a.arity, 1) + greater_of(b.arity, 1) - 2;
}

}  // namespace detail

/// The most visits of a whole query by any traversal, at any pose, on two meshes with so many
/// leaves, whose nodes have two children or more each, as `flashbvh bake` makes them. For two
/// images and `ranked`, `flashbvh collide --bound` knows the exact number, which is lower.
constexpr uint64_t most_visits(uint32_t leaves_a, uint32_t leaves_b) {
  return 2 * static_cast<uint64_t>(leaves_a) * leaves_b - 1;
}

/// The most work of a whole query in one run, of so many visits, and so many leaves taken as
/// shapes: where all boxes overlap, and all pairs of triangles are tested.
constexpr uint64_t most_work(const TreeSize& a, const TreeSize& b, uint64_t visits,
                             uint64_t shapes) {
  const uint64_t shape = detail::kShapeWork - 1 + detail::most_leaf_triangles(a, b);
  const uint64_t work = (1 + detail::kGoOnWork) * visits + shapes * shape +
                        uint64_t{detail::kTrianglePairWork} * a.triangle_count * b.triangle_count;
  return work + work / UINT16_MAX * detail::kTrianglePairWork;
}
/// By any traversal but `leaf`: a leaf is taken with one visit, and two or more are below it.
constexpr uint64_t most_work(const TreeSize& a, const TreeSize& b) {
  const uint64_t visits = most_visits(a.leaf_count, b.leaf_count);
  return most_work(a, b, visits, visits / 3);
}

/// The most work of one step: a run may overdraw by it, less 1.
constexpr uint64_t largest_step(const TreeSize& a, const TreeSize& b) {
  return detail::greater_of(detail::kTrianglePairWork,
                            detail::kShapeWork + detail::most_leaf_triangles(a, b));
}

/// The most instructions that a unit of work takes.
constexpr uint64_t instructions_of_work(const RunCosts& costs, const TreeSize& a,
                                        const TreeSize& b) {
  // A walk begins again for each pair of triangles at worst.
  const uint64_t siblings = detail::later_siblings(a, b) * costs.later_sibling;
  return costs.work + (siblings + detail::kTrianglePairWork - 1) / detail::kTrianglePairWork;
}

/// The most instructions that a run takes in addition to its work.
constexpr uint64_t instructions_of_start(const RunCosts& costs, const TreeSize& a,
                                         const TreeSize& b) {
  return costs.start + (uint64_t{a.depth} + b.depth) * costs.ascent +
         detail::later_siblings(a, b) * costs.later_sibling +
         (detail::most_leaf_triangles(a, b) - 1) * costs.leaf_triangle;
}

/// The most instructions of PairQuery::run(work, found), from `run` called to returned, whatever
/// the pose, and where the query stands. Not of UINT32_MAX, which is no limit.
constexpr uint64_t most_instructions(const RunCosts& costs, const TreeSize& a, const TreeSize& b,
                                     uint32_t work) {
  return instructions_of_start(costs, a, b) +
         (work + largest_step(a, b) - 1) * instructions_of_work(costs, a, b);
}

/// Of SelfQuery::run(work, found), whose ascents may pass by all siblings.
constexpr uint64_t most_instructions(const RunCosts& costs, const TreeSize& mesh, uint32_t work) {
  const uint64_t passed = (detail::later_siblings(mesh, mesh) + 1) * costs.later_sibling;
  return instructions_of_start(costs, mesh, mesh) + 2 * uint64_t{mesh.depth} * passed +
         (uint64_t{work} + detail::kTrianglePairWork - 1) * (costs.work + passed);
}

namespace detail {

/// What is in cycles where a read of flash takes so many wait states.
constexpr RunCosts with_waits(const RunCycles& core, uint32_t wait_states) {
  const RunCosts& cycles = core.cycles;
  const RunCosts& reads = core.reads;
  return {cycles.start + wait_states * reads.start, cycles.ascent + wait_states * reads.ascent,
          cycles.later_sibling + wait_states * reads.later_sibling,
          cycles.leaf_triangle + wait_states * reads.leaf_triangle,
          cycles.work + wait_states * reads.work};
}

}  // namespace detail

/// As most_instructions(), in cycles. `wait_states`: at most 1000, of each read of the memory that
/// code and meshes lie in; 0 of RAM. No cache is trusted.
constexpr uint64_t most_cycles(const RunCycles& core, uint32_t wait_states, const TreeSize& a,
                               const TreeSize& b, uint32_t work) {
  return most_instructions(detail::with_waits(core, wait_states), a, b, work);
}
/// Of a mesh against itself.
constexpr uint64_t most_cycles(const RunCycles& core, uint32_t wait_states, const TreeSize& mesh,
                               uint32_t work) {
  return most_instructions(detail::with_waits(core, wait_states), mesh, work);
}

namespace detail {

/// `none`: what a run without work takes at most.
constexpr uint32_t work_within(uint64_t instructions, uint64_t none, uint64_t of_work) {
  const uint64_t work = instructions < none ? 0 : (instructions - none) / of_work;
  return work < kUnlimited ? static_cast<uint32_t>(work) : kUnlimited - 1;
}

}  // namespace detail

/// The most work for which run(work, found) stays within so many instructions; 0 if none does, and
/// never UINT32_MAX.
constexpr uint32_t work_within(uint64_t instructions, const RunCosts& costs, const TreeSize& a,
                               const TreeSize& b) {
  return detail::work_within(instructions, most_instructions(costs, a, b, 0),
                             instructions_of_work(costs, a, b));
}
/// The same of a mesh against itself.
constexpr uint32_t work_within(uint64_t instructions, const RunCosts& costs, const TreeSize& mesh) {
  const uint64_t none = most_instructions(costs, mesh, 0);
  return detail::work_within(instructions, none, most_instructions(costs, mesh, 1) - none);
}

/// The most work for which run(work, found) stays within so many cycles; arguments as of
/// most_cycles().
constexpr uint32_t work_within(uint64_t cycles, const RunCycles& core, uint32_t wait_states,
                               const TreeSize& a, const TreeSize& b) {
  return work_within(cycles, detail::with_waits(core, wait_states), a, b);
}
/// Of a mesh against itself.
constexpr uint32_t work_within(uint64_t cycles, const RunCycles& core, uint32_t wait_states,
                               const TreeSize& mesh) {
  return work_within(cycles, detail::with_waits(core, wait_states), mesh);
}

}  // namespace flashbvh

#endif
