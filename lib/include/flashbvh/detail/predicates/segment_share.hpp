// Which of two places along a segment comes first.
#ifndef FLASHBVH_DETAIL_PREDICATES_SEGMENT_SHARE_HPP
#define FLASHBVH_DETAIL_PREDICATES_SEGMENT_SHARE_HPP

#include "flashbvh/lattice.hpp"

namespace flashbvh::detail {

/// -1, 0 or 1 as x is before, at or behind y. Exact.
int order_along(const SegmentShare& x, const SegmentShare& y) noexcept;

}  // namespace flashbvh::detail

#endif
