#include "flashbvh/detail/bounds/gap.hpp"

#include "flashbvh/detail/arch/packed_multiply.hpp"

#if defined(FLASHBVH_GAP_SIMD)
#include "../arch/sse2/gap.hpp"
#endif

#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

namespace {

/// Sums have kSplitBits of fraction. Boxes of A are rounded outwards, as vertices are not whole on
/// B's axes.
constexpr int32_t kOutwards = kSplitOne - 1;

#if !defined(FLASHBVH_GAP_SIMD)
struct Sums {
  int32_t upper;
  int32_t lower;
};
inline Sums sums_of(const SplitRow& row, const BoxTestStart& start, const PackedBox& box) {
  return {
      add_products(add_products(add_products(start.upper, row.positive_xy, box.upper_xy),
                                row.negative_xy, box.lower_xy),
                   row.z, box.z),
      add_crossed_products(add_products(add_products(start.lower, row.positive_xy, box.lower_xy),
                                        row.negative_xy, box.upper_xy),
                           row.z, box.z)};
}
#endif

/// Sets `seen` to the rotated `box`. `rounding`: added to sums before they become whole cells.
FLASHBVH_NOINLINE void rotate(const SplitMatrix& matrix, const BoxTestStart* starts,
                              int32_t rounding, const PackedBox& box, SeenBox& seen) {
#if defined(FLASHBVH_GAP_SIMD)
  rotate_lanes(matrix, starts, rounding, box, seen);
#else
  for (int i = 0; i < 3; ++i) {
    const Sums sums = sums_of(matrix.row[i], starts[i], box);
    seen.upper[i] = (sums.upper + rounding) >> kSplitBits;
    seen.lower[i] = (sums.lower + rounding) >> kSplitBits;
  }
#endif
}

/// Lower limits along an axis for the bounds of a box.
struct Halves {
  uint32_t upper;
  uint32_t lower;
};

/// Lower limits for the words of a box, to overlap the rotated `box`: `zero` less its sums.
inline PackedTriple window_of_rotated(const NearBox& kept, const PackedBox& box) {
#if defined(FLASHBVH_GAP_SIMD)
  return window_lanes(rotated_lanes(row_lanes(*kept.matrix), start_lanes(kept.starts), box),
                      kept.zero);
#else
  const auto least_half = [&](int32_t sum) {
    return saturated<16>((kept.zero - sum) >> kSplitBits);
  };
  const auto least = [&](int i) {
    const Sums sums = sums_of(kept.matrix->row[i], kept.starts[i], box);
    return Halves{least_half(sums.lower), least_half(sums.upper)};
  };
  const Halves x = least(0);
  const Halves y = least(1);
  const Halves z = least(2);
  return {{join_halves(x.upper, y.upper), join_halves(x.lower, y.lower),
           join_halves(z.upper, z.lower)}};
#endif
}

/// Rotates `box` and keeps it; true if `other` is within the limit of it.
FLASHBVH_NOINLINE bool rotate_near(NearBox& kept, const PackedBox& box, const PackedBox& other) {
  kept.window = window_of_rotated(kept, box);
  kept.source = &box;
  return is_within(kept.window, other, kept.limit);
}

/// Translates a box by the offset of a far B.
FLASHBVH_NOINLINE void move(SeenBox& seen, const Point& by) {
  const auto move_axis = [&seen](int axis, int32_t cells) {
    seen.upper[axis] += cells;
    seen.lower[axis] -= cells;
  };
  move_axis(0, by.x);
  move_axis(1, by.y);
  move_axis(2, by.z);
}

/// Kept out of line, so that other paths do not have its stack frame.
FLASHBVH_NOINLINE bool is_within_far(const Transform& transform, const GapLimit& limit,
                                     const PackedBox& a, const PackedBox& b) {
  return transform.is_rotated() ? RotatedGap(transform.rotated(), limit)(a, b)
                                : WideGap(transform.translated().offset, limit)(a, b);
}

}  // namespace

const SeenBox& RotatedGap::seen_of_a(const PackedBox& a) {
  if (a_.source != &a) {
    a_.source = &a;
    rotate(transform_->columns, transform_->on_b, kOutwards, a, a_.seen);
  }
  return a_.seen;
}

const SeenBox& RotatedGap::seen_of_b(const PackedBox& b) {
  if (b_.source != &b) {
    b_.source = &b;
    rotate(transform_->matrix->rows, transform_->on_a, 0, b, b_.seen);
  }
  return b_.seen;
}

uint32_t RotatedGap::squared(const PackedBox& a, const PackedBox& b) {
  return squared_gap(seen_of_b(b), a, limit_);
}

bool RotatedGap::operator()(const PackedBox& a, const PackedBox& b) {
  return squared(a, b) <= limit_.limit() &&
         squared_gap(seen_of_a(a), b, limit_) <= limit_.longer_limit();
}

KeptGap::KeptGap(const Transform& transform, const GapLimit& limit)
    : transform_(&transform), limit_(limit), rotates_(transform.is_rotated() && limit.is_near()) {
  if (!transform.is_rotated()) {
    return;  // NOLINT(clang-analyzer-optin.cplusplus.UninitializedObject): a rotation is not used
  }
  if (transform.is_far()) {
    limit_.make_coarse();
    rotates_ = false;
  }
  const RotatedTransform& rotated = transform.rotated();
  // One less than a cell, added before the shift, rounds a difference up.
  constexpr int32_t zero = 2 * kBoundBias * kSplitOne + kSplitOne - 1;
  a_ = {{{0, 0, 0}},  nullptr,          &rotated.columns,
        rotated.on_b, zero - kOutwards, limit.longer_limit()};
  b_ = {{{0, 0, 0}}, nullptr, &rotated.matrix->rows, rotated.on_a, zero, limit.limit()};
}

bool KeptGap::operator()(const PackedBox& a, const PackedBox& b) {
  // The current boxes go first.
  if (b_.source == &b) {
    return is_within(b_.window, a, b_.limit) && rotate_near(a_, a, b);
  }
  if (a_.source == &a) {
    return is_within(a_.window, b, a_.limit) && rotate_near(b_, b, a);
  }
  return compare_new(a, b);
}

bool KeptGap::compare_new(const PackedBox& a, const PackedBox& b) {
  if (!rotates_) {
    return transform_->is_far() ? detail::is_within_far(b, Side::b, a, *transform_, limit_)
                                : is_within_far(*transform_, limit_, a, b);
  }
  return rotate_near(b_, b, a) && rotate_near(a_, a, b);
}

const PackedTriple& KeptGap::window_of_a(const PackedBox& a) {
  if (a_.source != &a) {
    (void)rotate_near(a_, a, a);
    a_.source = rotates_ ? &a : nullptr;
  }
  return a_.window;
}

const PackedTriple& KeptGap::window_of_b(const PackedBox& b) {
  if (b_.source != &b) {
    (void)rotate_near(b_, b, b);
    b_.source = rotates_ ? &b : nullptr;
  }
  return b_.window;
}

bool is_within_far(const PackedBox& leaf, Side side, const PackedBox& box,
                   const Transform& transform, const GapLimit& limit) noexcept {
  if (!transform.is_rotated()) {
    const WideGap gap(transform.translated().offset, limit);
    return side == Side::a ? gap(leaf, box) : gap(box, leaf);
  }
  const RotatedTransform& rotated = transform.rotated();
  const PackedBox* turned = &leaf;
  const PackedBox* other = &box;
  if (transform.is_far() && side == Side::a) {  // on A's axes alone
    turned = &box;
    other = &leaf;
    side = Side::b;
  }
  SeenBox seen;
  if (side == Side::a) {
    rotate(rotated.columns, rotated.on_b, kOutwards, *turned, seen);
    return squared_gap(seen, *other, limit) <= limit.longer_limit();
  }
  rotate(rotated.matrix->rows, rotated.on_a, 0, *turned, seen);
  if (transform.is_far()) {
    move(seen, rotated.far_offset);
  }
  return squared_gap(seen, *other, limit) <= limit.limit();
}

uint32_t cells_in_unit(const PackedVector& direction) noexcept {
  // Newton's steps never fall below the root: the first one, from 2^13, is at most a quarter above
  // it, the third one 1 part in 3,000.
  const uint32_t squared_length = squared(direction);
  uint32_t root = (squared_length >> 14) + (1u << 12) + 1;
  root = (root + squared_length / root) / 2 + 1;
  root = (root + squared_length / root) / 2 + 1;
  return UINT32_MAX / root;
}

}  // namespace flashbvh::detail
