#include "flashbvh/detail/gap.hpp"

#include "flashbvh/detail/packed_multiply.hpp"

namespace flashbvh::detail {

FLASHBVH_NOINLINE void RotatedGap::rotate(const SplitMatrix& matrix, const BoundStart* starts,
                                          int32_t rounding, const PackedBox& box, Seen& seen) {
  seen.source = &box;
  for (int i = 0; i < 3; ++i) {
    const SplitRow& row = matrix.row[i];
    seen.upper[i] =
        add_products(
            add_products(add_products(starts[i].upper + rounding, row.positive_xy, box.upper_xy),
                         row.negative_xy, box.lower_xy),
            row.z, box.z) >>
        kSplitBits;
    seen.lower[i] =
        add_crossed_products(
            add_products(add_products(starts[i].lower + rounding, row.positive_xy, box.lower_xy),
                         row.negative_xy, box.upper_xy),
            row.z, box.z) >>
        kSplitBits;
  }
}

uint32_t RotatedGap::squared(const Seen& seen, const PackedBox& box) const {
  const auto along = [&](int axis, uint32_t upper, uint32_t lower) {
    return limit_.squared(gap_of(seen.upper[axis] + static_cast<int32_t>(lower),
                                 seen.lower[axis] + static_cast<int32_t>(upper)));
  };
  return along(0, low_half(box.upper_xy), low_half(box.lower_xy)) +
         along(1, high_half(box.upper_xy), high_half(box.lower_xy)) +
         along(2, low_half(box.z), high_half(box.z));
}

uint32_t RotatedGap::squared(const PackedBox& a, const PackedBox& b) {
  if (b_.source != &b) {
    rotate(transform_->matrix->rows, transform_->on_a, 0, b, b_);
  }
  return squared(b_, a);
}

bool RotatedGap::operator()(const PackedBox& a, const PackedBox& b) {
  // What is at hand goes first.
  if (a_.source == &a && squared(a_, b) > limit_.longer_limit()) {
    return false;
  }
  if (squared(a, b) > limit_.limit()) {
    return false;
  }
  if (a_.source == &a) {
    return true;
  }
  rotate(transform_->columns, transform_->on_b, kSplitOne - 1, a, a_);
  return squared(a_, b) <= limit_.longer_limit();
}

}  // namespace flashbvh::detail
