// Worst-case time of queries, for static_assert: lib/docs/bounded_time.md has the proof.
//
//     constexpr uint32_t kWork =
//         flashbvh::work_within(56000, flashbvh::kCortexM4F, arm_TREE_SIZE, cell_TREE_SIZE);
//     step = query.run(kWork, found);  // 56,000 instructions at most
#pragma once

#include <stdint.h>

#include "flashbvh/detail/walk/work.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/plain/core_costs.h"
#include "flashbvh/plain/results.h"

namespace flashbvh {

using RunCosts = flashbvh_run_costs;

/// Defines kCortexM0 to kRV32IMAC.
#define FLASHBVH_CONSTANT(core, c_name, text, ...) constexpr RunCosts k##core = {__VA_ARGS__};
FLASHBVH_FOR_EACH_CORE(FLASHBVH_CONSTANT)
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

}  // namespace flashbvh
