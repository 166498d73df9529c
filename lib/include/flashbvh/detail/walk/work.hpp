// The unit that runs are granted: work. How much of it a step takes is the same on every core, so
// that a query cut by work is cut in the same places; what one of it takes at most is not
// (time_bound.hpp).
//
// A visit is 1. The others were chosen from what they take at most in instructions, relative to a
// visit under a rotation, on the cores that the tests run on (lib/docs/bounded_time.md).
#ifndef FLASHBVH_DETAIL_WALK_WORK_HPP
#define FLASHBVH_DETAIL_WALK_WORK_HPP

#include <stdint.h>

namespace flashbvh::detail {

/// As much as it takes: none of it is spent.
constexpr uint32_t kUnlimited = UINT32_MAX;

/// Takes `spent` from what is left; the step that takes more is the last.
inline void take_work(uint32_t& left, uint32_t spent) {
  if (left != kUnlimited) {
    left = spent < left ? left - spent : 0;
  }
}

/// A leaf of one triangle taken as a shape, and begun below; each other triangle in it is 1 more.
constexpr uint32_t kShapeWork = 8;

/// Each triangle of a leaf of the other tree that the shape rejects by its corners.
constexpr uint32_t kRejectedTriangleWork = 1;

/// The same leaf below the next of the siblings among which a walk went on.
constexpr uint32_t kGoOnWork = 2;

/// Two triangles transformed and tested, with their part of a pair of leaves. A power of two: runs
/// divide by it.
constexpr uint32_t kTrianglePairWork = 32;

/// Two triangles tested for a distance: a walk at a distance tests hundreds that
/// boxes do not separate, and nearly all end at once.
constexpr uint32_t kNearPairWork = 8;
/// On top, those that don't; paid when a batch of them is done.
constexpr uint32_t kDearPairWork = 32;

/// The same along a direction that is kept, as they lie in flash. On top of it, to place those that
/// it doesn't separate; and the exact test of those that no direction does.
constexpr uint32_t kAlongPairWork = 1;
constexpr uint32_t kPlacedPairWork = 4;
constexpr uint32_t kExactPairWork = 24;

/// How many pairs of triangles are tested for so much work, the last one for what is left of it.
template <uint32_t pair_work = kTrianglePairWork>
constexpr uint32_t triangle_pairs_for(uint32_t work) {
  return work / pair_work + (work % pair_work != 0 ? 1 : 0);
}

}  // namespace flashbvh::detail

#endif
