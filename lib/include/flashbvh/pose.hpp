// Where B lies in A's frame: a rotation in fixed point and a translation in cells.
#ifndef FLASHBVH_POSE_HPP
#define FLASHBVH_POSE_HPP

#include <stdint.h>

#include "flashbvh/status.hpp"

namespace flashbvh {

/// One in the fixed point of a rotation: 30 fraction bits.
constexpr int32_t kRotationOne = 1 << 30;

/// How far R^T R may be from the identity, entry by entry, for R to count as a rotation: 2^-13, in
/// the fixed point of a rotation. A matrix written with four decimals passes.
constexpr int32_t kRotationTolerance = kRotationOne >> 13;

/// Largest magnitude of a translation, in cells: differences of origins and translations then stay
/// in 32 bits. Objects that far apart cannot touch: a mesh is at most 2 * kMaxCoordinate cells
/// wide.
constexpr int32_t kMaxTranslation = 1 << 29;

/// B's point p, in cells of B's frame, lies at rotation * p + translation in A's frame. 60 bytes.
///
/// Checked when it is made, so that a query need not: a pose that can't be is kept as an error,
/// which every query on it returns, and every pose made of it.
class Pose {
 public:
  /// B moved, not turned. Cells: the mesh's unit divided by the cell, rounded. Beyond
  /// +-kMaxTranslation the pose's status is `translation_out_of_range`.
  static constexpr Pose translated(int32_t x, int32_t y, int32_t z) { return Pose(x, y, z); }

  /// B turned and moved. `rotation`: row by row, kRotationOne is 1. `cells`: the translation,
  /// rounded to whole cells; `fraction`: what rounding left, in 1/65,536 of a cell, -32,768 to
  /// 32,767. A matrix further than kRotationTolerance from a rotation, or a mirroring one, gives
  /// `not_a_rotation`; it is used as it is, not mended. About 250 instructions on a Cortex-M4.
  static Pose rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3],
                    const int16_t (&fraction)[3]);
  static Pose rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3]);

  /// First `inner`, then `outer`: B in A's frame from B in C's and C in A's. Each entry of the
  /// rotation is rounded to 2^-30, the translation to 2^-16 cells. Tolerances add up: a product of
  /// inexact matrices may be `not_a_rotation`.
  static Pose composed(const Pose& outer, const Pose& inner);

  /// A in B's frame from B in A's: the transposed matrix.
  Pose inverse() const;

  /// B in A's frame from both in the world's.
  static Pose relative(const Pose& world_a, const Pose& world_b) {
    return composed(world_a.inverse(), world_b);
  }

  /// `done` if queries can use the pose, else why not.
  constexpr Status status() const { return status_; }

  /// In cells, rounded to the nearest. `axis`: 0 to 2.
  constexpr int32_t translation(int axis) const { return cells_[axis]; }
  /// What is left of it, in 1/65,536 of a cell: -32,768 to 32,767.
  constexpr int32_t fraction(int axis) const { return fraction_[axis]; }
  /// kRotationOne is 1. `row` and `column`: 0 to 2.
  constexpr int32_t rotation(int row, int column) const { return rotation_[row][column]; }

  /// Whether the rotation is exactly the identity.
  constexpr bool is_translation() const { return !turned_; }
  /// How far R^T R is from the identity at most, entry by entry: 24 fraction bits, rounded up.
  constexpr uint32_t defect() const { return defect_; }

 private:
  constexpr Pose(int32_t x, int32_t y, int32_t z)
      : rotation_{{kRotationOne, 0, 0}, {0, kRotationOne, 0}, {0, 0, kRotationOne}},
        cells_{x, y, z},
        fraction_{0, 0, 0},
        defect_(0),
        turned_(false),
        status_(in_range(x) && in_range(y) && in_range(z) ? Status::done
                                                          : Status::translation_out_of_range) {}

  static constexpr bool in_range(int32_t t) {
    constexpr uint32_t most = kMaxTranslation;
    return static_cast<uint32_t>(t) + most <= 2 * most;
  }

  /// The translation's component along `axis`, with 30 fraction bits.
  void set_translation(int axis, int64_t t);
  void check_rotation();

  int32_t rotation_[3][3];  ///< row by row
  int32_t cells_[3];
  int16_t fraction_[3];
  uint16_t defect_;
  bool turned_;
  Status status_;
};

}  // namespace flashbvh

#endif
