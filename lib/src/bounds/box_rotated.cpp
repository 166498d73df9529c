#include "flashbvh/detail/bounds/box_rotated.hpp"

#include "flashbvh/detail/arch/packed_multiply.hpp"

#if defined(FLASHBVH_ROTATE_SSE2)
#include "box_rotated_sse2.hpp"
#elif defined(__thumb__) && __ARM_ARCH_PROFILE == 'M' && !defined(FLASHBVH_PORTABLE)
#define FLASHBVH_ROTATE_ASSEMBLY 1
#if defined(__ARM_FEATURE_DSP)
#include "box_rotated_dsp.hpp"
#elif defined(__thumb2__)
#include "box_rotated_thumb2.hpp"
#else
#include "box_rotated_thumb1.hpp"
#endif
#elif !defined(FLASHBVH_PORTABLE)
#define FLASHBVH_ROTATE_PLAIN 1
#include "box_rotated_plain.hpp"
#endif

namespace flashbvh::detail {
namespace {

#if defined(FLASHBVH_PORTABLE)

/// Rounds a biased bound down to whole cells, clamped to the lattice: against a box on the lattice
/// that decides alike.
inline uint32_t whole_bound(int32_t bound) {
  return saturated<15>(bound >> kSplitBits);
}

inline uint32_t upper_bound(const SplitRow& row, int32_t start, const PackedBox& box) {
  return whole_bound(add_products(add_products(add_products(start, row.positive_xy, box.upper_xy),
                                               row.negative_xy, box.lower_xy),
                                  row.z, box.z));
}

inline uint32_t lower_bound(const SplitRow& row, int32_t start, const PackedBox& box) {
  return whole_bound(
      add_crossed_products(add_products(add_products(start, row.positive_xy, box.lower_xy),
                                        row.negative_xy, box.upper_xy),
                           row.z, box.z));
}

/// Returns the bounds of a rotated box on the other lattice.
inline PackedBox rotated(const SplitMatrix& matrix, const BoxTestStart* starts,
                         const PackedBox& box) {
  const auto upper = [&](int i) { return upper_bound(matrix.row[i], starts[i].upper, box); };
  const auto lower = [&](int i) { return lower_bound(matrix.row[i], starts[i].lower, box); };
  return {join_halves(upper(0), upper(1)), join_halves(lower(0), lower(1)),
          join_halves(upper(2), lower(2))};
}

#endif

#if !defined(FLASHBVH_ROTATE_ASSEMBLY)

/// Rotates `box` and keeps it; 0 if it overlaps `other`.
FLASHBVH_NOINLINE uint32_t rotate_and_compare(RotatedBox& kept, const PackedBox& box,
                                              const PackedBox& other) {
#if defined(FLASHBVH_ROTATE_SSE2)
  kept.bounds = rotated_sse2(kept.by, box);
#elif defined(FLASHBVH_ROTATE_PLAIN)
  rotate_plain(*kept.by.matrix, kept.by.starts, box, kept.bounds);
#else
  kept.bounds = rotated(*kept.by.matrix, kept.by.starts, box);
#endif
  kept.source = &box;
  return compare(kept.bounds, other);
}

#endif

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

}  // namespace flashbvh::detail
