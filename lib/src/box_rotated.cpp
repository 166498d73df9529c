#include "flashbvh/box_rotated.hpp"

namespace flashbvh {
namespace {

/// Doubled centre and doubled half extents of a box, as signed halves.
struct Doubled {
  uint32_t centre_xy;
  uint32_t extent_xy;
  uint32_t centre_z;  ///< in the low half
  uint32_t extent_z;
};

constexpr uint32_t kHighBits = 0x80008000u;

inline Doubled doubled(const PackedBox& box) {
  // Biased bounds have 15 bits: the top bit of each half stops the borrow between them, and the
  // bias of a sum is that bit alone.
  return {((box.upper_xy | kHighBits) - box.lower_xy) ^ kHighBits,
          (box.upper_xy + box.lower_xy) ^ kHighBits, low_half(box.z) - high_half(box.z),
          (low_half(box.z) + high_half(box.z)) ^ 0x8000u};
}

/// The magnitudes of two signed halves, none of them -32,768.
inline uint32_t absolute_halves(uint32_t word) {
  const int32_t low = signed_low(word);
  const int32_t high = signed_high(word);
  return join_signed(low < 0 ? -low : low, high < 0 ? -high : high);
}

/// Whole cells of a bound, biased: 0 stands for all below the lattice, 32,767 for its end and all
/// above, which is the same against any box of A.
inline uint32_t whole_bound(int32_t bound) {
  const int32_t cells = bound >> kPlacementBits;
  return static_cast<uint32_t>(cells < 0 ? 0 : cells > 0x7FFF ? 0x7FFF : cells);
}

/// Scales of the second test: 4,096 is one cell.
constexpr int32_t kHalfCellOfAxis = 2048;

}  // namespace

RotatedOverlap::RotatedOverlap(const RotatedPlacement& placement)
    : placement_(&placement), placed_for_(nullptr) {
  const PackedMatrix& r = placement.rotation;
  absolute_ = {{absolute_halves(r.xy[0]), absolute_halves(r.xy[1]), absolute_halves(r.xy[2])},
               absolute_halves(r.z01),
               absolute_halves(r.z2)};
}

inline void RotatedOverlap::place(const PackedBox& b) {
  const RotatedPlacement& p = *placement_;
  const Doubled box = doubled(b);
  const int32_t margin = p.box_margin + (kBoundBias << kPlacementBits) + kPlacementOne / 2;
  const auto centre = [&](int i, int32_t z) {
    return ((multiply_pairs(p.rotation.xy[i], box.centre_xy) + z) >> 1) + p.offset[i];
  };
  const auto half = [&](int i, int32_t z) {
    return ((multiply_pairs(absolute_.xy[i], box.extent_xy) + z) >> 1) + margin;
  };
  const int32_t x = centre(0, add_low_low(0, p.rotation.z01, box.centre_z));
  const int32_t y = centre(1, add_high_low(0, p.rotation.z01, box.centre_z));
  const int32_t z = centre(2, add_low_low(0, p.rotation.z2, box.centre_z));
  const int32_t half_x = half(0, add_low_low(0, absolute_.z01, box.extent_z));
  const int32_t half_y = half(1, add_high_low(0, absolute_.z01, box.extent_z));
  const int32_t half_z = half(2, add_low_low(0, absolute_.z2, box.extent_z));
  placed_ = {join_halves(whole_bound(half_x + x), whole_bound(half_y + y)),
             join_halves(whole_bound(half_x - x), whole_bound(half_y - y)),
             join_halves(whole_bound(half_z + z), whole_bound(half_z - z))};
  centre_[0] = x;
  centre_[1] = y;
  centre_[2] = z;
  placed_for_ = &b;
}

inline bool RotatedOverlap::apart_along_b(const PackedBox& a, const PackedBox& b) const {
  const PackedMatrix& r = placement_->rotation;
  const PackedMatrix& s = absolute_;
  const Doubled of_a = doubled(a);
  const Doubled of_b = doubled(b);
  const int32_t dx = centre_[0] - signed_low(of_a.centre_xy) * (kPlacementOne / 2);
  const int32_t dy = centre_[1] - signed_high(of_a.centre_xy) * (kPlacementOne / 2);
  const int32_t dz = centre_[2] - signed_low(of_a.centre_z) * (kPlacementOne / 2);
  const int32_t margin = placement_->axis_margin;

  const auto apart = [&](int32_t distance, int32_t half_a, int32_t extent_b) {
    const int32_t reach = (half_a >> 3) + extent_b * kHalfCellOfAxis + margin;
    return distance > reach || -distance > reach;
  };
  return apart(add_wide_low(add_wide_low(add_wide_low(0, dx, r.xy[0]), dy, r.xy[1]), dz, r.xy[2]),
               add_low_low(
                   add_low_high(add_low_low(0, s.xy[0], of_a.extent_xy), s.xy[1], of_a.extent_xy),
                   s.xy[2], of_a.extent_z),
               signed_low(of_b.extent_xy)) ||
         apart(
             add_wide_high(add_wide_high(add_wide_high(0, dx, r.xy[0]), dy, r.xy[1]), dz, r.xy[2]),
             add_high_low(
                 add_high_high(add_high_low(0, s.xy[0], of_a.extent_xy), s.xy[1], of_a.extent_xy),
                 s.xy[2], of_a.extent_z),
             signed_high(of_b.extent_xy)) ||
         apart(add_wide_low(add_wide_high(add_wide_low(0, dx, r.z01), dy, r.z01), dz, r.z2),
               add_low_low(
                   add_high_high(add_low_low(0, s.z01, of_a.extent_xy), s.z01, of_a.extent_xy),
                   s.z2, of_a.extent_z),
               signed_low(of_b.extent_z));
}

bool RotatedOverlap::overlap(const PackedBox& a, const PackedBox& b) {
  if (placed_for_ != &b) {
    place(b);
  }
  const uint32_t sums = (a.upper_xy + placed_.lower_xy) & (a.lower_xy + placed_.upper_xy) &
                        (a.z + swap_halves(placed_.z));
  return (sums & kHighBits) == kHighBits && !apart_along_b(a, b);
}

}  // namespace flashbvh
