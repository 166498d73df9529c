// Separating-axis test of a segment and boxes: the box's axes, and in each coordinate plane the
// normal of the segment.
#include "../predicates/fine_crossing.hpp"
#include "flashbvh/detail/walk/segment_walk.hpp"

namespace flashbvh::detail {
namespace {

int32_t span_of(int32_t value) {
  return value < 0 ? -value : value;
}

/// Returns whether the line through (0, 0) along `way` meets the rectangle with centre `middle` and
/// half extents `half`. All arguments are in one unit, below 2^22.
bool meets(int32_t way_u, int32_t way_v, int32_t middle_u, int32_t middle_v, int32_t half_u,
           int32_t half_v) {
  const int64_t aside = int64_t{way_u} * middle_v - int64_t{way_v} * middle_u;
  const int64_t most = int64_t{span_of(way_u)} * half_v + int64_t{span_of(way_v)} * half_u;
  return aside <= most && -aside <= most;
}

}  // namespace

SegmentInBoxes::SegmentInBoxes(const Segment& segment)
    : from_{segment.from.x, segment.from.y, segment.from.z},
      way_{segment.to.x - segment.from.x, segment.to.y - segment.from.y,
           segment.to.z - segment.from.z} {
  for (int i = 0; i < 3; ++i) {
    const int32_t to = from_[i] + way_[i];
    upper_[i] = from_[i] < to ? to : from_[i];
    lower_[i] = from_[i] < to ? from_[i] : to;
  }
}

bool SegmentInBoxes::may_meet(const PackedBox& box) const {
  const int32_t upper[3] = {unpack_bound(low_half(box.upper_xy)),
                            unpack_bound(high_half(box.upper_xy)), unpack_bound(low_half(box.z))};
  const int32_t lower[3] = {-unpack_bound(low_half(box.lower_xy)),
                            -unpack_bound(high_half(box.lower_xy)),
                            -unpack_bound(high_half(box.z))};
  // `middle`: twice the vector from the segment's start to the box's centre.
  int32_t middle[3];
  int32_t size[3];
  for (int i = 0; i < 3; ++i) {
    if (lower[i] > upper_[i] || upper[i] < lower_[i]) {
      return false;
    }
    middle[i] = upper[i] + lower[i] - 2 * from_[i];
    size[i] = upper[i] - lower[i];
  }
  return meets(way_[0], way_[1], middle[0], middle[1], size[0], size[1]) &&
         meets(way_[1], way_[2], middle[1], middle[2], size[1], size[2]) &&
         meets(way_[2], way_[0], middle[2], middle[0], size[2], size[0]);
}

void SegmentInBoxes::shorten(const SegmentShare& along) {
  const Segment segment = {{from_[0], from_[1], from_[2]},
                           {from_[0] + way_[0], from_[1] + way_[1], from_[2] + way_[2]}};
  FinePoint fine;
  set_crossing(segment.from, segment.to, along.above, along.above - along.below, fine);
  const int64_t end[3] = {fine.x, fine.y, fine.z};
  for (int i = 0; i < 3; ++i) {
    // Whole cells, rounded down; `fine` is within 1/256 cell of the end.
    const auto cell = static_cast<int32_t>(end[i] >> 8);
    static_assert(kFineOne == 1 << 8, "a cell's steps");
    if (way_[i] < 0) {
      lower_[i] = cell - 1;
    } else {
      upper_[i] = cell + 2;
    }
  }
}

}  // namespace flashbvh::detail
