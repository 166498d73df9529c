#include "flashbvh/detail/bounds/leaf_gap.hpp"

#include "../predicates/short_root.hpp"

namespace flashbvh::detail {
namespace {

/// Not below the root of `value`, and above it by at most 2 and one part in 2^30. Below 2^62.
uint32_t root_above(uint64_t value) {
  if (value == 0) {
    return 0;
  }
  // Of the leading 31 or 32 bits, and one of Newton's steps, which are never below.
  const int zeros = __builtin_clzll(value);
  const int down = zeros < 32 ? (33 - zeros) & ~1 : 0;
  const uint64_t above = uint64_t{short_root(static_cast<uint32_t>(value >> down)) + 1}
                         << (down / 2);
  return static_cast<uint32_t>((above + value / above) / 2 + 1);
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

}  // namespace flashbvh::detail
