// How far two boxes are apart at least: the box test of predicates of distance.
//
// Along an axis the gap of two boxes is what is missing for them to overlap; gaps along orthogonal
// axes are squared and added. Under a rotation that is done on A's axes and on B's, and either must
// be near enough. Sums of bounds are those of box.hpp and box_rotated.hpp, with the same margins,
// but nothing is cut off at the lattice's end: a gap is a number here, not a sign.
//
// Where the limit is less than 2^15 cells, gaps are halves of words, two axes at once: what is
// missing is what a subtraction leaves that saturates at 0, and 2^15 is beyond the limit. Farther
// limits, and a translated B that is farther off than halves hold, go the long way.
//
// On B's axes, the columns n_j of the rotation with 14 bits, a vector w has sum (n_j . w)^2 <=
// |N|^2 |w|^2, and |N|^2 is at most (1 + defect / 2 + 3 * 2^-15)^2, which is below 1 + 2^-10 where
// no entry of R^T R is off by more than 2^-13: the limit there is larger by so much. Bounds on A's
// axes are of vertices, which are whole: they are rounded inwards. On B's axes they are not: there
// they are rounded outwards.
#ifndef FLASHBVH_DETAIL_BOUNDS_GAP_HPP
#define FLASHBVH_DETAIL_BOUNDS_GAP_HPP

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

namespace flashbvh::detail {

/// Squared gaps, and what they must not exceed to matter, in 32 bits. Where the limit has more than
/// 30 bits gaps are counted in fours of cells, rounded down, where it has more than 35 in more.
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

  /// Counts in fours of cells at least, so that the limit is not near.
  constexpr void make_coarse() {
    if (shift_ == 0) {
      shift_ = kFours;
      limit_ = (limit_ >> (2 * kFours)) + 1;
    }
  }

  constexpr uint32_t limit() const { return limit_; }
  /// For vectors that may be longer by one part in 2^11 than what they stand for.
  constexpr uint32_t longer_limit() const { return clamped(int64_t{limit_} + (limit_ >> 10) + 1); }

  /// For sums of squared gaps along directions that are nearly orthogonal (proximity_planes.hpp).
  constexpr uint32_t sum_limit() const { return clamped(int64_t{limit_} + (limit_ >> 9) + 1); }

  /// Whether a gap of 2^15 cells is beyond all of these but the sums' one.
  constexpr bool is_near() const { return shift_ == 0 && longer_limit() < 1u << 30; }

  /// `gap`: of any sign; none if it is negative.
  FLASHBVH_INLINE uint32_t squared(int32_t gap) const {
    const uint32_t size = gap < 0 ? 0 : static_cast<uint32_t>(gap) >> shift_;
    const uint32_t cut = size < kMost ? size : kMost;
    return cut * cut;
  }

  /// Gaps beyond it count as this: three squares of it stay in 32 bits, and one alone is over a
  /// limit of 30.
  static constexpr uint32_t kMost = 37'837;
  constexpr uint32_t shift() const { return shift_; }

 private:
  static_assert(uint64_t{3} * kMost * kMost <= UINT32_MAX, "sums of three squares");

  static constexpr uint32_t kFours = 2;
  /// The shift above the limit, of more than 30 bits: in a register each. Beyond 2^44 nothing is
  /// rejected, however gaps are counted.
  [[gnu::noinline]] static constexpr uint64_t shifted(int64_t squared) {
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

/// What is missing along an axis: for the upper bound of one box and the lower of the other, or the
/// other way round. Sums of biased bounds.
FLASHBVH_INLINE inline int32_t gap_of(int32_t upper, int32_t lower) {
  constexpr int32_t zero = 2 * kBoundBias;
  return zero - (upper < lower ? upper : lower);
}

/// A box seen from the other lattice: biased bounds in cells, upper and negated lower, anywhere.
struct SeenBox {
#if defined(FLASHBVH_GAP_SIMD)
  alignas(16) int32_t upper[4];  // lanes
  alignas(16) int32_t lower[4];
#else
  int32_t upper[3];
  int32_t lower[3];
#endif
};

/// `cells`: by which it is translated.
inline SeenBox seen_translated(const PackedBox& box, const Point& cells) {
  const auto bound = [](uint32_t half, int32_t by) { return static_cast<int32_t>(half) + by; };
  return {{bound(low_half(box.upper_xy), cells.x), bound(high_half(box.upper_xy), cells.y),
           bound(low_half(box.z), cells.z)},
          {bound(low_half(box.lower_xy), -cells.x), bound(high_half(box.lower_xy), -cells.y),
           bound(high_half(box.z), -cells.z)}};
}

/// At most the square of the distance to a box of the lattice, as GapLimit has it: axis by axis,
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

/// The same.
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

/// What the words of a box have to reach to overlap a seen one. No more than a half holds: what is
/// cut off is missing 2^15 or more all the same.
inline PackedTriple window_of(const SeenBox& seen) {
  const auto least = [](int32_t bound) {
    const int32_t missing = 2 * kBoundBias - bound;
    return static_cast<uint32_t>(missing < 0 ? 0 : missing > 0xFFFF ? 0xFFFF : missing);
  };
  return {{join_halves(least(seen.lower[0]), least(seen.lower[1])),
           join_halves(least(seen.upper[0]), least(seen.upper[1])),
           join_halves(least(seen.lower[2]), least(seen.upper[2]))}};
}

/// Whether what three words, of upper and lower x and y and of z, are missing to what they have to
/// reach is within a limit, which 2^15 is not. Of an axis's two bounds no more than one is missed.
FLASHBVH_INLINE inline bool is_within(const PackedTriple& least, const PackedTriple& words,
                                      uint32_t limit) {
#if defined(__ARM_FEATURE_SIMD32) || defined(FLASHBVH_PORTABLE)
  constexpr uint32_t far = 0x80008000u;
  const uint32_t xy =
      subtract_halves(least.word[0], words.word[0]) | subtract_halves(least.word[1], words.word[1]);
  const uint32_t z = subtract_halves(least.word[2], words.word[2]);
  return ((xy | z) & far) == 0 && sum_of_squares(xy, z) <= limit;
#else  // axis by axis: halves need not be joined, and the first may reject
  constexpr int32_t far = 1 << 15;
  uint32_t sum = 0;
  const auto add = [&](uint32_t least_upper, uint32_t upper, uint32_t least_lower, uint32_t lower) {
    const auto of_upper = static_cast<int32_t>(least_upper - upper);
    const auto of_lower = static_cast<int32_t>(least_lower - lower);
    const int32_t missing = of_upper > of_lower ? of_upper : of_lower;
    if (missing <= 0) {
      return true;
    }
    sum += static_cast<uint32_t>(missing) * static_cast<uint32_t>(missing);
    return missing < far && sum <= limit;
  };
  const uint32_t(&l)[3] = least.word;
  const uint32_t(&w)[3] = words.word;
  return add(low_half(l[0]), low_half(w[0]), low_half(l[1]), low_half(w[1])) &&
         add(high_half(l[0]), high_half(w[0]), high_half(l[1]), high_half(w[1])) &&
         add(low_half(l[2]), low_half(w[2]), high_half(l[2]), high_half(w[2]));
#endif
}
/// The same of a window and a box.
FLASHBVH_INLINE inline bool is_within(const PackedTriple& window, const PackedBox& box,
                                      uint32_t limit) {
#if defined(FLASHBVH_GAP_SIMD)
  return is_within_lanes(word_lanes(window.word[0]), word_lanes(box.upper_xy), limit);
#else
  return is_within(window, PackedTriple{{box.upper_xy, box.lower_xy, box.z}}, limit);
#endif
}

/// The square of the distance of the boxes' middles, in fours of cells, as gaps beyond a limit of
/// 30 bits are counted: below 2^31.
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

/// B translated, the long way.
class WideGap {
 public:
  /// `offset`: of B, within +-kMaxOffset; outlives this.
  WideGap(const Point& offset, const GapLimit& limit) : offset_(&offset), limit_(limit) {}

  /// False only if no points of the boxes are within the limit.
  FLASHBVH_INLINE bool operator()(const PackedBox& a, const PackedBox& b) const {
    return squared(a, b) <= limit_.limit();
  }
  /// Which boxes seem nearest, where gaps alone do not decide: as many boxes overlap.
  uint32_t guess(const PackedBox& a, const PackedBox& b) const {
    return squared_middles(seen_translated(b, *offset_), a) + squared(a, b);
  }
  /// At most the square of the distance, as GapLimit has it.
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

/// The same answers for a walk, from what its registers hold.
class TranslatedGap {
 public:
  /// `offset`: of B; both fit.
  TranslatedGap(const Point& offset, const GapLimit& limit) : limit_(limit) {
    constexpr int32_t zero = 2 * kBoundBias;  // what a sum of two bounds has if they are equal
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

/// B rotated, the long way. Boxes are known by their addresses.
class RotatedGap {
 public:
  RotatedGap(const RotatedTransform& transform, const GapLimit& limit)
      : transform_(&transform), limit_(limit) {}

  /// False only if nothing in the boxes is within the limit.
  bool operator()(const PackedBox& a, const PackedBox& b);
  /// At most the square of the distance, as GapLimit has it: on A's axes alone.
  uint32_t squared(const PackedBox& a, const PackedBox& b);
  /// Which boxes seem nearest, where gaps alone do not decide.
  uint32_t guess(const PackedBox& a, const PackedBox& b) {
    return squared_middles(seen_of_b(b), a) + squared(a, b);
  }

  /// A box of A on B's lattice, and the other way round.
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

/// A box that was rotated last, and what is within a limit of it.
struct NearBox {
  PackedTriple window;
  const PackedBox* source = nullptr;
  const SplitMatrix* matrix;
  const BoxTestStart* starts;
  int32_t zero;    ///< from which sums are subtracted for the window, rounding included
  uint32_t limit;  ///< of squared gaps
};

/// Any B, for a walk, in whose run it lives: one that is rotated, and whatever does not fit
/// TranslatedGap.
class KeptGap {
 public:
  KeptGap(const Transform& transform, const GapLimit& limit);
  /// Whether these need it.
  static bool is_for(const Transform& transform, const GapLimit& limit) {
    return transform.is_rotated() || !TranslatedGap::fit(transform.translated().offset, limit);
  }

  /// False only if nothing in the boxes is within the limit.
  bool operator()(const PackedBox& a, const PackedBox& b);
  const GapLimit& limit() const { return limit_; }

  /// Of a B that is rotated: what a box of B has to reach to overlap `a` on B's lattice; and the
  /// other way round. Of a far B anything, as no limit is near there.
  const PackedTriple& window_of_a(const PackedBox& a);
  const PackedTriple& window_of_b(const PackedBox& b);

 private:
  /// Neither box is current: the exception, and all that needs registers saved. The long way
  /// keeps none.
  FLASHBVH_NOINLINE bool compare_new(const PackedBox& a, const PackedBox& b);

  const Transform* transform_;
  GapLimit limit_;
  bool rotates_;  ///< or goes the long way
  NearBox a_;
  NearBox b_;
};

/// In a unit of a direction so many cells, times 2^32, rounded down. `direction`: along which
/// distances are true, in A's lattice; of 13 bits.
uint32_t cells_in_unit(const PackedVector& direction) noexcept;

/// Whether a leaf's own box and one of the other tree are within a limit, the long way (gap.hpp).
bool is_within_far(const PackedBox& leaf, Side side, const PackedBox& box,
                   const Transform& transform, const GapLimit& limit) noexcept;

}  // namespace flashbvh::detail

#endif
