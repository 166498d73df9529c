#include "flashbvh/detail/bounds/box_rotated.hpp"

#include "../arch/rotate_box.hpp"

namespace flashbvh::detail {
namespace {

/// Rotates `b` and, if it overlaps `a`, also `a`; 0 if they overlap. Kept out of line: the case is
/// rare, and RotatedBoxTest::gap() saves fewer registers without it.
FLASHBVH_NOINLINE uint32_t rotate_both(RotatedBox& kept_a, RotatedBox& kept_b, const PackedBox& a,
                                       const PackedBox& b) {
  const uint32_t gap = rotate_and_compare(kept_b, b, a);
  return gap != 0 ? gap : rotate_and_compare(kept_a, a, b);
}

}  // namespace

uint32_t RotatedBoxTest::gap(const PackedBox& a, const PackedBox& b) {
  if (b_.source == &b) {
    const uint32_t gap = compare(b_.bounds, a);
    return gap != 0 ? gap : rotate_and_compare(a_, a, b);
  }
  if (a_.source == &a) {
    const uint32_t gap = compare(a_.bounds, b);
    return gap != 0 ? gap : rotate_and_compare(b_, b, a);
  }
  return rotate_both(a_, b_, a, b);
}

void RotatedBoxTest::keep(RotatedBox& kept, const PackedBox& box) {
  if (kept.source != &box) {
    (void)rotate_and_compare(kept, box, box);
  }
}

PackedTriple RotatedBoxTest::window(const RotatedBox& kept, const PackedBox& box) {
  if (kept.source != &box) {
    return {{0, 0, 0}};
  }
  constexpr uint32_t zero = 2 * kBoundBias;  // the sum of two equal bounds
  constexpr uint32_t zeros = join_halves(zero, zero);
  return detail::window({{zeros, zeros, zeros}}, kept.bounds);
}

PackedTriple RotatedBoxTest::window_of(const RotatedTransform& transform, bool of_a,
                                       const PackedBox& box) {
  RotatedBox kept = {{0, 0, 0},
                     nullptr,
                     of_a ? BoxRotation(transform.columns, transform.on_b)
                          : BoxRotation(transform.matrix->rows, transform.on_a)};
  keep(kept, box);
  return window(kept, box);
}

}  // namespace flashbvh::detail
