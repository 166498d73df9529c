#include "flashbvh/detail/gap.hpp"

#include "flashbvh/detail/near_shape.hpp"
#include "flashbvh/detail/packed_multiply.hpp"

namespace flashbvh::detail {

FLASHBVH_NOINLINE void RotatedGap::rotate(const SplitMatrix& matrix, const BoundStart* starts,
                                          int32_t rounding, const PackedBox& box, Kept& kept) {
  kept.source = &box;
  for (int i = 0; i < 3; ++i) {
    const SplitRow& row = matrix.row[i];
    const int32_t upper = add_products(
        add_products(add_products(starts[i].upper + rounding, row.positive_xy, box.upper_xy),
                     row.negative_xy, box.lower_xy),
        row.z, box.z);
    const int32_t lower = add_crossed_products(
        add_products(add_products(starts[i].lower + rounding, row.positive_xy, box.lower_xy),
                     row.negative_xy, box.upper_xy),
        row.z, box.z);
    kept.seen.upper[i] = upper >> kSplitBits;
    kept.seen.lower[i] = lower >> kSplitBits;
  }
}

const SeenBox& RotatedGap::seen_of_a(const PackedBox& a) {
  if (a_.source != &a) {
    rotate(transform_->columns, transform_->on_b, kSplitOne - 1, a, a_);
  }
  return a_.seen;
}

const SeenBox& RotatedGap::seen_of_b(const PackedBox& b) {
  if (b_.source != &b) {
    rotate(transform_->matrix->rows, transform_->on_a, 0, b, b_);
  }
  return b_.seen;
}

uint32_t RotatedGap::squared(const PackedBox& a, const PackedBox& b) {
  return squared_gap(seen_of_b(b), a, limit_);
}

bool RotatedGap::operator()(const PackedBox& a, const PackedBox& b) {
  // What is at hand goes first.
  if (a_.source == &a) {
    return squared_gap(a_.seen, b, limit_) <= limit_.longer_limit() &&
           squared(a, b) <= limit_.limit();
  }
  return squared(a, b) <= limit_.limit() &&
         squared_gap(seen_of_a(a), b, limit_) <= limit_.longer_limit();
}

uint32_t cells_in_unit(const PackedVector& direction) noexcept {
  // Newton's steps are never below the root: the first one, from 2^13, is at most a quarter above
  // it, the third 1 part in 3,000.
  const uint32_t squared_length = squared(direction);
  uint32_t root = (squared_length >> 14) + (1u << 12) + 1;
  root = (root + squared_length / root) / 2 + 1;
  root = (root + squared_length / root) / 2 + 1;
  return UINT32_MAX / root;
}

}  // namespace flashbvh::detail
