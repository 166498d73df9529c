#include "flashbvh/detail/bounds/leaf_gap.hpp"

#include "../predicates/short_root.hpp"

#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {
namespace {

/// Upper bound on the root of `value`, above it by at most 2 and one part in 2^30. `value`: below
/// 2^62.
uint32_t root_above(uint64_t value) {
  if (value == 0) {
    return 0;
  }
  // The root of the leading 31 or 32 bits, and one Newton step, which never ends below the root.
  const int zeros = __builtin_clzll(value);
  const int down = zeros < 32 ? (33 - zeros) & ~1 : 0;
  const uint64_t above = uint64_t{short_root(static_cast<uint32_t>(value >> down)) + 1}
                         << (down / 2);
  return static_cast<uint32_t>((above + value / above) / 2 + 1);
}

/// Direction of a far offset, whose largest component has 13 bits or fewer.
PackedVector along_offset(const Point& offset) {
  constexpr int down = 8;
  static_assert(kMaxFarOffset >> down < 1 << kDirectionBits, "13 bits");
  return {
      join_halves(static_cast<uint16_t>(offset.x >> down), static_cast<uint16_t>(offset.y >> down)),
      offset.z >> down};
}

SplitRow row_of(const PackedVector& v) {
  return SplitRow::of(v.x(), v.y(), v.z);
}

}  // namespace

SupportGap::SupportGap(const LeafGap& gap)
    : of_a_(row_of(gap.on_a_)), of_b_(SplitRow::of(-gap.on_b_.x(), -gap.on_b_.y(), -gap.on_b_.z)) {
  const int64_t most = int64_t{gap.origin_} + int64_t{of_a_.sum() + of_b_.sum()} * kBoundBias -
                       root_above(gap.squared_);
  most_ = most < kNothing ? kNothing : static_cast<int32_t>(most);
}

SupportGap::SupportGap(const Transform& transform) noexcept
    : SupportGap(along_offset(transform.far_offset()), transform, INT64_MAX) {}

SupportGap::SupportGap(const PackedVector& direction, const Transform& transform,
                       int64_t limit) noexcept {
  Slab slab;
  slab.begin(direction, {0, 0});
  slab.rotate(transform, Side::a);
  const PackedVector seen = slab.seen_direction();
  of_a_ = row_of(direction);
  of_b_ = SplitRow::of(-seen.x(), -seen.y(), -seen.z);
  most_ = kNothing;
  if (limit >= int64_t{1} << 43) {
    return;
  }
  // Both roots have fraction bits, so that rounding adds far less than a cell.
  const Point& moved = transform.far_offset();
  const uint64_t cells = root_above(static_cast<uint64_t>(limit + 1) << 18);  // 2^9 is a cell
  const uint64_t length = root_above(uint64_t{squared(direction)} << 32);     // 2^16 is a unit
  const int64_t most = int64_t{slab.least_lower()} + Transform::kFarMargin +
                       int64_t{of_a_.sum()} * kBoundBias + int64_t{direction.x()} * moved.x +
                       int64_t{direction.y()} * moved.y + int64_t{direction.z} * moved.z -
                       static_cast<int64_t>((cells * length >> 25) + 1);
  // Ends add up to less than 2^31; the margin is for nearly_separates().
  constexpr int64_t enough = INT32_MAX - (1 << 20);
  most_ = static_cast<int32_t>(most < kNothing ? kNothing : most > enough ? enough : most);
}

uint32_t SupportGap::guess(const PackedBox& a, const PackedBox& b) const noexcept {
  return UINT32_MAX - static_cast<uint32_t>(end_along(of_a_, a)) -
         static_cast<uint32_t>(end_along(of_b_, b));
}

}  // namespace flashbvh::detail
