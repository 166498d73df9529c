// Work, the unit of a run's budget. A step has one price on all cores, so that a budget cuts a
// query in the same places. The most instructions per unit depend on the core (time_bound.hpp).
//
// A visit costs 1. The other prices follow from the most instructions of a step, relative to a
// visit under a rotation, on the tested cores (lib/docs/bounded_time.md).
#pragma once

#include <stdint.h>

namespace flashbvh::detail {

/// An unlimited budget, which is never spent.
constexpr uint32_t kUnlimited = UINT32_MAX;

/// Subtracts `spent` from the work left; a step that costs more is the last.
inline void take_work(uint32_t& left, uint32_t spent) {
  if (left != kUnlimited) {
    left = spent < left ? left - spent : 0;
  }
}

/// Making the planes of a leaf of one triangle and starting below it; 1 more per further triangle.
constexpr uint32_t kShapeWork = 8;

/// Each triangle of a leaf of the other tree that the leaf's plane rejects by its corners.
constexpr uint32_t kRejectedTriangleWork = 1;

/// A pair of leaves that the other leaf's plane rejects, by this leaf's corners; and
/// kRejectedTriangleWork for each triangle of the larger leaf.
constexpr uint32_t kOtherPlaneWork = 3;

/// The next subtree against an unchanged leaf, in a walk that resumed below the leaf.
constexpr uint32_t kGoOnWork = 2;

/// Two triangles transformed and tested, with their share of a pair of leaves. A power of two, as
/// runs divide by it.
constexpr uint32_t kTrianglePairWork = 32;

/// Two triangles tested for a distance. A walk at a distance tests hundreds that boxes do not
/// separate, and early tests reject nearly all.
constexpr uint32_t kNearPairWork = 8;
/// Extra for each other pair; charged after a batch.
constexpr uint32_t kExpensivePairWork = 32;

/// Two triangles tested in flash along a stored direction. Extra, in this order: placing a pair
/// that it does not separate; the exact test of a pair that no direction separates.
constexpr uint32_t kAlongPairWork = 1;
constexpr uint32_t kPlacedPairWork = 4;
constexpr uint32_t kExactPairWork = 24;

/// A guard's measurement of a pair of links: their spheres and pose; each joint's lever; the
/// distance of two triangles with the next limit.
constexpr uint32_t kPoseWork = 16;
constexpr uint32_t kLeverWork = 1;
constexpr uint32_t kAimWork = 56;

/// The number of pairs of triangles that `work` allows; the last may exceed the work left for it.
template <uint32_t pair_work = kTrianglePairWork>
constexpr uint32_t triangle_pairs_for(uint32_t work) {
  return work / pair_work + (work % pair_work != 0 ? 1 : 0);
}

}  // namespace flashbvh::detail
