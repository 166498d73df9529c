// Lower bounds on the distance of two boxes: the box test of predicates of distance.
//
// Squared gaps along orthogonal axes add up. Under a rotation the sum on A's axes and the sum on
// B's must both be within the limit, which on B's axes is larger by one part in 2^10. Bounds are
// not clamped at the lattice's end: a gap's size counts. Margins: lib/docs/derivations.md,
// "Distances".
//
// If the limit is less than 2^15 cells, gaps are halves of words, two axes at once. Larger limits,
// and a translated B that is too far off for halves, take the wide form, with gaps of 32 bits.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/arch/packed_multiply.hpp"
#include "flashbvh/detail/bounds/rotated_transform.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"
#include "flashbvh/detail/lattice/packed_vector.hpp"

#if defined(__SSE2__) && !defined(FLASHBVH_PORTABLE)
#define FLASHBVH_GAP_SIMD 1
#include "flashbvh/detail/bounds/gap_simd.hpp"
#endif

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// Squared gaps and their limit, in 32 bits. For limits of more than 30 bits, gaps count in units
/// of four cells, rounded down; for more than 35 bits, in larger units.
class GapLimit {
 public:
  /// `squared`: the largest square of a distance that still matters, in square cells.
  explicit constexpr GapLimit(int64_t squared) : shift_(0), limit_(clamped(squared)) {
    if (squared >= int64_t{1} << 30) {
      const uint64_t both = shifted(squared);
      shift_ = static_cast<uint32_t>(both >> 32);
      limit_ = static_cast<uint32_t>(both);
    }
  }

  /// Counts in units of at least four cells, so that is_near() is false.
  constexpr void make_coarse() {
    if (shift_ == 0) {
      shift_ = kFours;
      limit_ = (limit_ >> (2 * kFours)) + 1;
    }
  }

  constexpr uint32_t limit() const { return limit_; }
  /// For vectors that may be too long by one part in 2^11.
  constexpr uint32_t longer_limit() const { return clamped(int64_t{limit_} + (limit_ >> 10) + 1); }

  /// For sums of squared gaps along directions that are nearly orthogonal (proximity_planes.hpp).
  constexpr uint32_t sum_limit() const { return clamped(int64_t{limit_} + (limit_ >> 9) + 1); }

  /// True if a gap of 2^15 cells exceeds limit() and longer_limit().
  constexpr bool is_near() const { return shift_ == 0 && longer_limit() < 1u << 30; }

  /// `gap`: of any sign; a negative gap counts as 0.
  FLASHBVH_INLINE uint32_t squared(int32_t gap) const {
    const uint32_t size = gap < 0 ? 0 : static_cast<uint32_t>(gap) >> shift_;
    const uint32_t cut = size < kMost ? size : kMost;
    return cut * cut;
  }

  /// Gaps are clamped to this: three squares of it fit 32 bits, and one square exceeds a limit of
  /// 30 bits.
  static constexpr uint32_t kMost = 37'837;
  constexpr uint32_t shift() const { return shift_; }

 private:
  static_assert(uint64_t{3} * kMost * kMost <= UINT32_MAX, "sums of three squares");

  static constexpr uint32_t kFours = 2;
  /// Returns the shift in the high word and the limit, of more than 30 bits, in the low word, one
  /// register each. Beyond 2^44 no gap is rejected in any unit.
  [[gnu::__noinline__]] static constexpr uint64_t shifted(int64_t squared) {
    uint32_t shift = kFours;
    squared >>= 2 * kFours;
    while (squared >= int64_t{1} << 31 && squared < int64_t{1} << 40) {
      ++shift;
      squared >>= 2;
    }
    return uint64_t{shift} << 32 | clamped(squared + 1);
  }

  static constexpr uint32_t clamped(int64_t squared) {
    return squared < 0 ? 0 : squared > UINT32_MAX ? UINT32_MAX : static_cast<uint32_t>(squared);
  }

  uint32_t shift_;
  uint32_t limit_;
};

/// The gap along an axis; not positive if there is none. Takes both sums of a biased upper bound of
/// one box and a biased, negated lower bound of the other.
FLASHBVH_INLINE inline int32_t gap_of(int32_t upper, int32_t lower) {
  constexpr int32_t zero = 2 * kBoundBias;
  return zero - (upper < lower ? upper : lower);
}

/// A box seen from the other lattice: biased bounds in cells, upper and negated lower, unclamped.
struct SeenBox {
#if defined(FLASHBVH_GAP_SIMD)
  alignas(16) int32_t upper[4];  // lanes
  alignas(16) int32_t lower[4];
#else
  int32_t upper[3];
  int32_t lower[3];
#endif
};

/// Translates a box by `cells`.
inline SeenBox seen_translated(const PackedBox& box, const Point& cells) {
  const auto bound = [](uint32_t half, int32_t by) { return static_cast<int32_t>(half) + by; };
  return {{bound(low_half(box.upper_xy), cells.x), bound(high_half(box.upper_xy), cells.y),
           bound(low_half(box.z), cells.z)},
          {bound(low_half(box.lower_xy), -cells.x), bound(high_half(box.lower_xy), -cells.y),
           bound(high_half(box.z), -cells.z)}};
}

/// A lower bound on the squared distance to a box of the lattice, in GapLimit's unit: axis by axis,
/// the reference of squared_gap().
FLASHBVH_INLINE inline uint32_t squared_gap_by_axis(const SeenBox& seen, const PackedBox& box,
                                                    const GapLimit& limit) {
  const auto along = [&](int axis, uint32_t upper, uint32_t lower) {
    return limit.squared(gap_of(seen.upper[axis] + static_cast<int32_t>(lower),
                                seen.lower[axis] + static_cast<int32_t>(upper)));
  };
  return along(0, low_half(box.upper_xy), low_half(box.lower_xy)) +
         along(1, high_half(box.upper_xy), high_half(box.lower_xy)) +
         along(2, low_half(box.z), high_half(box.z));
}

/// squared_gap_by_axis(), with SSE2 where there is SSE2.
FLASHBVH_INLINE inline uint32_t squared_gap(const SeenBox& seen, const PackedBox& box,
                                            const GapLimit& limit) {
#if defined(FLASHBVH_GAP_SIMD)
  const auto lanes = [](const int32_t(&bounds)[4]) {
    return _mm_load_si128(reinterpret_cast<const __m128i*>(bounds));
  };
  const BoxTestLanes bounds = bound_lanes(box);
  return squared_gap_lanes(_mm_add_epi32(lanes(seen.upper), bounds.lower),
                           _mm_add_epi32(lanes(seen.lower), bounds.upper), 2 * kBoundBias,
                           limit.shift(), GapLimit::kMost);
#else
  return squared_gap_by_axis(seen, box, limit);
#endif
}

/// Lower limits for a box's packed words: a box that reaches all of them overlaps the seen box.
/// Limits are clamped to a half, as every box misses such a limit by 2^15 or more all the same.
inline PackedTriple window_of(const SeenBox& seen) {
  const auto least = [](int32_t bound) { return saturated<16>(2 * kBoundBias - bound); };
  return {{join_halves(least(seen.lower[0]), least(seen.lower[1])),
           join_halves(least(seen.upper[0]), least(seen.upper[1])),
           join_halves(least(seen.lower[2]), least(seen.upper[2]))}};
}

/// True if the gaps, by which `words` of a box miss the limits `least`, are within a squared limit,
/// which is below 2^30. Words: upper x and y, lower x and y, z. At most one of an axis's two bounds
/// is missed.
FLASHBVH_INLINE inline bool is_within(const PackedTriple& least, const PackedTriple& words,
                                      uint32_t limit) {
#if defined(__ARM_FEATURE_SIMD32) && !defined(FLASHBVH_PORTABLE)
  constexpr uint32_t far_bits = 0x80008000u;
  const uint32_t xy =
      subtract_halves(least.word[0], words.word[0]) | subtract_halves(least.word[1], words.word[1]);
  const uint32_t z = subtract_halves(least.word[2], words.word[2]);
  return ((xy | z) & far_bits) == 0 && sum_of_squares(xy, z) <= limit;
#else  // axis by axis: no halves are joined, and the first axis may reject
  constexpr int32_t least_far = 1 << 15;
  uint32_t sum = 0;
  const auto add = [&](uint32_t least_upper, uint32_t upper, uint32_t least_lower, uint32_t lower) {
    const auto of_upper = static_cast<int32_t>(least_upper - upper);
    const auto of_lower = static_cast<int32_t>(least_lower - lower);
    const int32_t missing = of_upper > of_lower ? of_upper : of_lower;
    if (missing <= 0) {
      return true;
    }
    sum += static_cast<uint32_t>(missing) * static_cast<uint32_t>(missing);
    return missing < least_far && sum <= limit;
  };
  const uint32_t(&l)[3] = least.word;
  const uint32_t(&w)[3] = words.word;
  return add(low_half(l[0]), low_half(w[0]), low_half(l[1]), low_half(w[1])) &&
         add(high_half(l[0]), high_half(w[0]), high_half(l[1]), high_half(w[1])) &&
         add(low_half(l[2]), low_half(w[2]), high_half(l[2]), high_half(w[2]));
#endif
}
/// is_within() for a window and a box.
FLASHBVH_INLINE inline bool is_within(const PackedTriple& window, const PackedBox& box,
                                      uint32_t limit) {
#if defined(FLASHBVH_GAP_SIMD)
  return is_within_lanes(word_lanes(window.word[0]), word_lanes(box.upper_xy), limit);
#else
  return is_within(window, PackedTriple{{box.upper_xy, box.lower_xy, box.z}}, limit);
#endif
}

/// The squared distance of the boxes' middles, in units of four cells as for limits of more than 30
/// bits: below 2^31.
inline uint32_t squared_middles(const SeenBox& seen, const PackedBox& box) {
  const auto along = [&](int axis, uint32_t upper, uint32_t lower) {
    const int32_t apart = (seen.upper[axis] - seen.lower[axis] - static_cast<int32_t>(upper) +
                           static_cast<int32_t>(lower)) >>
                          3;
    return static_cast<uint32_t>(apart * apart);
  };
  return along(0, low_half(box.upper_xy), low_half(box.lower_xy)) +
         along(1, high_half(box.upper_xy), high_half(box.lower_xy)) +
         along(2, low_half(box.z), high_half(box.z));
}

/// The wide form of the gap test for a translated B.
class WideGap {
 public:
  /// `offset`: of B, within +-kMaxOffset; outlives this.
  WideGap(const Point& offset, const GapLimit& limit) : offset_(&offset), limit_(limit) {}

  /// False only if no points of the boxes are within the limit.
  FLASHBVH_INLINE bool operator()(const PackedBox& a, const PackedBox& b) const {
    return squared(a, b) <= limit_.limit();
  }
  /// Smaller for boxes that seem nearer; gaps alone do not decide, as many boxes overlap.
  uint32_t guess(const PackedBox& a, const PackedBox& b) const {
    return squared_middles(seen_translated(b, *offset_), a) + squared(a, b);
  }
  /// A lower bound on the squared distance, in GapLimit's unit.
  FLASHBVH_INLINE uint32_t squared(const PackedBox& a, const PackedBox& b) const {
#if defined(FLASHBVH_GAP_SIMD)
    const BoxTestLanes of_a = bound_lanes(a);
    const BoxTestLanes of_b = bound_lanes(b);
    const __m128i offset = _mm_set_epi32(0, offset_->z, offset_->y, offset_->x);
    return squared_gap_lanes(_mm_sub_epi32(_mm_add_epi32(of_a.upper, of_b.lower), offset),
                             _mm_add_epi32(_mm_add_epi32(of_a.lower, of_b.upper), offset),
                             2 * kBoundBias, limit_.shift(), GapLimit::kMost);
#else
    const uint32_t upper_xy = a.upper_xy + b.lower_xy;
    const uint32_t lower_xy = a.lower_xy + b.upper_xy;
    const uint32_t both_z = a.z + swap_halves(b.z);
    const auto along = [this](uint32_t upper, uint32_t lower, int32_t offset) {
      return limit_.squared(
          gap_of(static_cast<int32_t>(upper) - offset, static_cast<int32_t>(lower) + offset));
    };
    return along(low_half(upper_xy), low_half(lower_xy), offset_->x) +
           along(high_half(upper_xy), high_half(lower_xy), offset_->y) +
           along(low_half(both_z), high_half(both_z), offset_->z);
#endif
  }

 private:
  const Point* offset_;
  GapLimit limit_;
};

/// WideGap's answers for a walk, whose registers hold all of this.
class TranslatedGap {
 public:
  /// `offset`: of B; fit(offset, limit) holds.
  TranslatedGap(const Point& offset, const GapLimit& limit) : limit_(limit) {
    constexpr int32_t zero = 2 * kBoundBias;  // the sum of two equal bounds
    const auto halves = [](int32_t low, int32_t high) {
      return join_halves(static_cast<uint32_t>(zero + low), static_cast<uint32_t>(zero + high));
    };
    least_ = {
        {halves(offset.x, offset.y), halves(-offset.x, -offset.y), halves(offset.z, -offset.z)}};
  }
  static bool fit(const Point& offset, const GapLimit& limit) {
    const auto is_near = [](int32_t along) {
      constexpr int32_t most = 0xFFFF - 2 * kBoundBias;
      return -most <= along && along <= most;
    };
    return limit.is_near() && is_near(offset.x) && is_near(offset.y) && is_near(offset.z);
  }

  const GapLimit& limit() const { return limit_; }
  /// False only if no points of the boxes are within the limit.
  FLASHBVH_INLINE bool operator()(const PackedBox& a, const PackedBox& b) const {
#if defined(FLASHBVH_GAP_SIMD)
    return is_within_lanes(word_lanes(least_.word[0]), sum_lanes(a, b), limit_.limit());
#else
    return is_within(
        least_,
        PackedTriple{{a.upper_xy + b.lower_xy, a.lower_xy + b.upper_xy, a.z + swap_halves(b.z)}},
        limit_.limit());
#endif
  }

 private:
  PackedTriple least_;
  GapLimit limit_;
};

/// The wide form for a rotated B. A box is identified by its address.
class RotatedGap {
 public:
  RotatedGap(const RotatedTransform& transform, const GapLimit& limit)
      : transform_(&transform), limit_(limit) {}

  /// False only if nothing in the boxes is within the limit.
  bool operator()(const PackedBox& a, const PackedBox& b);
  /// A lower bound on the squared distance, in GapLimit's unit: on A's axes alone.
  uint32_t squared(const PackedBox& a, const PackedBox& b);
  /// Smaller for boxes that seem nearer; gaps alone do not decide.
  uint32_t guess(const PackedBox& a, const PackedBox& b) {
    return squared_middles(seen_of_b(b), a) + squared(a, b);
  }

  /// A box of A on B's lattice; a box of B on A's.
  const SeenBox& seen_of_a(const PackedBox& a);
  const SeenBox& seen_of_b(const PackedBox& b);

 private:
  struct Kept {
    const PackedBox* source = nullptr;
    SeenBox seen;
  };

  const RotatedTransform* transform_;
  GapLimit limit_;
  Kept a_;
  Kept b_;
};

/// The box rotated last, and its window and limit.
struct NearBox {
  PackedTriple window;
  const PackedBox* source = nullptr;
  const SplitMatrix* matrix;
  const BoxTestStart* starts;
  int32_t zero;    ///< the window is this, rounding included, less the sums
  uint32_t limit;  ///< of squared gaps
};

/// The gap test of a walk for a rotated B, or for a B that does not fit TranslatedGap. Lives as
/// long as a run.
class KeptGap {
 public:
  KeptGap(const Transform& transform, const GapLimit& limit);
  /// True if this transform and limit need a KeptGap.
  static bool is_for(const Transform& transform, const GapLimit& limit) {
    return transform.is_rotated() || !TranslatedGap::fit(transform.translated().offset, limit);
  }

  /// False only if nothing in the boxes is within the limit.
  bool operator()(const PackedBox& a, const PackedBox& b);
  const GapLimit& limit() const { return limit_; }

  /// For a rotated B: lower limits for the packed words of a box of B, to overlap `a` on B's
  /// lattice. window_of_b(): of a box of A. Not valid for a far B, where no limit is near.
  const PackedTriple& window_of_a(const PackedBox& a);
  const PackedTriple& window_of_b(const PackedBox& b);

 private:
  /// Tests two boxes of which neither is current: the exception, and the only case that needs saved
  /// registers. The wide form never has a current box.
  FLASHBVH_NOINLINE bool compare_new(const PackedBox& a, const PackedBox& b);

  const Transform* transform_;
  GapLimit limit_;
  bool rotates_;  ///< false: takes the wide form
  NearBox a_;
  NearBox b_;
};

/// Cells per unit of a direction, times 2^32, rounded down. `direction`: of 13 bits, in A's
/// lattice, where lengths are true.
uint32_t cells_in_unit(const PackedVector& direction) noexcept;

/// True if a leaf's own box and a box of the other tree are within a limit, by the wide form.
bool is_within_far(const PackedBox& leaf, Side side, const PackedBox& box,
                   const Transform& transform, const GapLimit& limit) noexcept;

}  // namespace flashbvh::detail

#pragma GCC diagnostic pop
