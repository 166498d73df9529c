// How far two boxes are apart at least: the bounds of questions about distance.
//
// Along an axis the gap of two boxes is what is missing for them to overlap; gaps along orthogonal
// axes are squared and added. Under a rotation that is done on A's axes and on B's, and either must
// be near enough. Sums of bounds are those of box.hpp and box_rotated.hpp, with the same margins,
// but nothing is cut off at the lattice's end: a gap is a number here, not a sign.
//
// On B's axes, the columns n_j of the rotation with 14 bits, a vector w has sum (n_j . w)^2 <=
// |N|^2 |w|^2, and |N|^2 is at most (1 + defect / 2 + 3 * 2^-15)^2, which is below 1 + 2^-10 where
// no entry of R^T R is off by more than 2^-13: the limit there is larger by so much. Bounds on A's
// axes are of vertices, which are whole: they are rounded inwards. On B's axes they are not: there
// they are rounded outwards.
#ifndef FLASHBVH_DETAIL_GAP_HPP
#define FLASHBVH_DETAIL_GAP_HPP

#include <stdint.h>

#include "flashbvh/detail/box_packed.hpp"
#include "flashbvh/detail/inline.hpp"
#include "flashbvh/detail/rotated_transform.hpp"

namespace flashbvh::detail {

/// Squared gaps, and what they must not exceed to matter, in 32 bits. A gap is within 92,761 cells.
/// Where the limit has more than 30 bits gaps are counted in fours of cells, rounded down.
class GapLimit {
 public:
  /// `squared`: the largest square of a distance that still matters, in square cells.
  explicit constexpr GapLimit(int64_t squared)
      : shift_(squared < int64_t{1} << 30 ? 0 : 2),
        limit_(clamped(shift_ == 0 ? squared : (squared >> 4) + 1)) {}

  constexpr uint32_t limit() const { return limit_; }
  /// For vectors that may be longer by one part in 2^11 than what they stand for.
  constexpr uint32_t longer_limit() const { return clamped(int64_t{limit_} + (limit_ >> 10) + 1); }

  /// For sums of squared gaps along directions that are nearly orthogonal (near_shape.hpp).
  constexpr uint32_t sum_limit() const { return clamped(int64_t{limit_} + (limit_ >> 9) + 1); }

  /// `gap`: of any sign; none if it is negative.
  FLASHBVH_INLINE uint32_t squared(int32_t gap) const {
    const uint32_t size = gap < 0 ? 0 : static_cast<uint32_t>(gap) >> shift_;
    const uint32_t cut = size < kMost ? size : kMost;
    return cut * cut;
  }

 private:
  /// Three squares of it stay in 32 bits, and one alone is over a limit of 30.
  static constexpr uint32_t kMost = 37'837;
  static_assert(uint64_t{3} * kMost * kMost <= UINT32_MAX, "sums of three squares");

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
  int32_t upper[3];
  int32_t lower[3];
};

/// `cells`: by which it is translated.
inline SeenBox seen_translated(const PackedBox& box, const Point& cells) {
  const auto bound = [](uint32_t half, int32_t by) { return static_cast<int32_t>(half) + by; };
  return {{bound(low_half(box.upper_xy), cells.x), bound(high_half(box.upper_xy), cells.y),
           bound(low_half(box.z), cells.z)},
          {bound(low_half(box.lower_xy), -cells.x), bound(high_half(box.lower_xy), -cells.y),
           bound(high_half(box.z), -cells.z)}};
}

/// At most the square of the distance to a box of the lattice, as GapLimit has it.
FLASHBVH_INLINE inline uint32_t squared_gap(const SeenBox& seen, const PackedBox& box,
                                            const GapLimit& limit) {
  const auto along = [&](int axis, uint32_t upper, uint32_t lower) {
    return limit.squared(gap_of(seen.upper[axis] + static_cast<int32_t>(lower),
                                seen.lower[axis] + static_cast<int32_t>(upper)));
  };
  return along(0, low_half(box.upper_xy), low_half(box.lower_xy)) +
         along(1, high_half(box.upper_xy), high_half(box.lower_xy)) +
         along(2, low_half(box.z), high_half(box.z));
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

/// B translated.
class TranslatedGap {
 public:
  /// `offset`: of B, within +-kMaxOffset.
  TranslatedGap(const Point& offset, const GapLimit& limit) : offset_(offset), limit_(limit) {}

  /// False only if no points of the boxes are within the limit.
  FLASHBVH_INLINE bool operator()(const PackedBox& a, const PackedBox& b) const {
    return squared(a, b) <= limit_.limit();
  }
  const GapLimit& limit() const { return limit_; }
  /// Which boxes seem nearest, where gaps alone don't tell: as many boxes overlap.
  uint32_t guess(const PackedBox& a, const PackedBox& b) const {
    return squared_middles(seen_translated(b, offset_), a) + squared(a, b);
  }
  /// At most the square of the distance, as GapLimit has it.
  FLASHBVH_INLINE uint32_t squared(const PackedBox& a, const PackedBox& b) const {
    const uint32_t upper_xy = a.upper_xy + b.lower_xy;
    const uint32_t lower_xy = a.lower_xy + b.upper_xy;
    const uint32_t both_z = a.z + swap_halves(b.z);
    const auto along = [this](uint32_t upper, uint32_t lower, int32_t offset) {
      return limit_.squared(
          gap_of(static_cast<int32_t>(upper) - offset, static_cast<int32_t>(lower) + offset));
    };
    return along(low_half(upper_xy), low_half(lower_xy), offset_.x) +
           along(high_half(upper_xy), high_half(lower_xy), offset_.y) +
           along(low_half(both_z), high_half(both_z), offset_.z);
  }

 private:
  Point offset_;
  GapLimit limit_;
};

/// B rotated. Lives as long as a run of a walk; boxes are known by their addresses.
class RotatedGap {
 public:
  RotatedGap(const RotatedTransform& transform, const GapLimit& limit)
      : transform_(&transform), limit_(limit) {}

  /// False only if nothing in the boxes is within the limit.
  bool operator()(const PackedBox& a, const PackedBox& b);
  /// At most the square of the distance, as GapLimit has it: on A's axes alone.
  uint32_t squared(const PackedBox& a, const PackedBox& b);
  const GapLimit& limit() const { return limit_; }
  /// Which boxes seem nearest, where gaps alone don't tell.
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
  /// `rounding`: added to sums before they become whole cells.
  static void rotate(const SplitMatrix& matrix, const BoundStart* starts, int32_t rounding,
                     const PackedBox& box, Kept& kept);

  const RotatedTransform* transform_;
  GapLimit limit_;
  Kept a_;
  Kept b_;
};

}  // namespace flashbvh::detail

#endif
