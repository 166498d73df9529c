// B's pose in A's frame: a rotation in fixed point and a translation in cells.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/lattice/split_matrix.hpp"
#include "flashbvh/plain/points.h"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// 1 in the fixed point of a rotation: 30 fraction bits.
constexpr int32_t kRotationOne = 1 << 30;

/// Tolerance of a rotation matrix R: no entry of R^T R may differ from the identity's by more than
/// 2^-13, in the fixed point of a rotation. A matrix of five decimals passes; one of four may not.
constexpr int32_t kRotationTolerance = kRotationOne >> 13;

/// Largest magnitude of a translation along each axis, in cells: differences of origins and
/// translations then fit 32 bits. Objects that far apart cannot touch: a mesh is at most
/// 2 * kMaxCoordinate cells wide.
constexpr int32_t kMaxTranslation = 1 << 29;

/// Maps B's point p, in cells of B's frame, to rotation * p + translation in A's frame. 68 bytes.
///
/// Queries need not check a pose: it is checked when it is made and stores its error. Each query on
/// the pose returns that error, and each pose made from it inherits the error. A pose is constant
/// once made, so queries, tasks and interrupts may share it. Assigning to a pose that others read
/// needs a lock.
///
/// Instructions on a Cortex-M4 at -O2: rigid() 580, relative() 1,060, composed() and inverse() less
/// (lib/docs/figures.md has all cores). Stack in bytes, on Cortex-M3 to M55 at -O2: rigid() 112,
/// inverse() 176, composed() and relative() 288.
class Pose {
 public:
  /// Returns a translation of B in cells: lengths in the mesh's unit divided by the cell, rounded.
  /// `translation_out_of_range`: a coordinate is beyond +-kMaxTranslation.
  static constexpr Pose translated(int32_t x, int32_t y, int32_t z) { return Pose(x, y, z); }

  /// Returns a pose that rotates and translates B. `rotation`: row by row, kRotationOne is 1;
  /// rounded to 2^-22. `cells`: the translation, rounded to whole cells. `fraction`: the remainder
  /// of that rounding, in 1/65,536 cell, -32,768 to 32,767. `not_a_rotation`: the matrix exceeds
  /// kRotationTolerance or mirrors. A matrix within the tolerance is used as it is, not repaired.
  static Pose rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3],
                    const int16_t (&fraction)[3]);
  /// Returns a pose that rotates B and translates it by whole cells.
  static Pose rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3]);

  /// composed(), inverse() and relative() add up the deviations of their factors' matrices from
  /// rotations, instead of measuring the product's. Queries may make a few visits more than with
  /// the same numbers given to rigid(); the answers are equal.
  ///
  /// Applies `inner`, then `outer`: returns B in A's frame from B in C's frame and C in A's. Rounds
  /// each entry of the rotation to 2^-22 and the translation to 2^-16 cells. Tolerances add up: a
  /// product of inexact matrices may be `not_a_rotation`.
  static Pose composed(const Pose& outer, const Pose& inner);

  /// Returns A in B's frame, by the transposed matrix.
  Pose inverse() const;

  /// Returns B in A's frame from the world poses of both; rounded once, as in composed().
  static Pose relative(const Pose& world_a, const Pose& world_b);

  /// `done` if queries can use the pose, else its error.
  constexpr Status status() const { return status_; }

  /// Returns the translation in cells, rounded to the nearest. `axis`: 0 to 2.
  constexpr int32_t translation(int axis) const { return cells_[axis]; }
  /// Returns the remainder of that rounding in 1/65,536 cell: -32,768 to 32,767.
  constexpr int32_t fraction(int axis) const { return fraction_[axis]; }
  /// Returns an entry of the rotation; kRotationOne is 1. `row` and `column`: 0 to 2.
  constexpr int32_t rotation(int row, int column) const {
    if (!rotated_) {
      return row == column ? kRotationOne : 0;
    }
    int32_t entry[3] = {};
    matrix_.get_row(row, entry[0], entry[1], entry[2]);
    return entry[column] * (1 << (30 - detail::kRotationBits));
  }

  /// True if the rotation is exactly the identity.
  constexpr bool is_translation() const { return !rotated_; }

  /// For the library: the rotation's matrix, valid if the pose is not a translation.
  constexpr const detail::RotationMatrix& matrix() const { return matrix_; }

 private:
  using Entries = int32_t[3][3];  ///< with kRotationBits fraction bits

  constexpr Pose(int32_t x, int32_t y, int32_t z)
      : none_(),
        cells_{x, y, z},
        fraction_{0, 0, 0},
        rotated_(false),
        status_(in_range(x) && in_range(y) && in_range(z) ? Status::done
                                                          : Status::translation_out_of_range) {}

  static constexpr bool in_range(int32_t t) {
    constexpr uint32_t most = kMaxTranslation;
    return static_cast<uint32_t>(t) + most <= 2 * most;
  }

  constexpr uint32_t defect() const { return rotated_ ? matrix_.defect : 0; }

  void get_rotation(Entries& entries) const;
  void get_transposed(Entries& entries) const;
  void set_rotation(const Entries& entries, uint32_t defect);
  /// Sets the product of two rotations, `right` transposed. `defects`: the sum of their defects; a
  /// large sum is replaced by the product's measured defect.
  void set_product(const Entries& left, const Entries& right, uint32_t defects);
  void refuse(Status status) { status_ = status_ == Status::done ? status : status_; }
  /// Sets left * (cells, fraction), plus the translation of `added_to` unless that is null.
  void set_translation(const Entries& left, const int32_t (&cells)[3], const int32_t (&fraction)[3],
                       const Pose* added_to);

  union {
    detail::RotationMatrix matrix_;  ///< if rotated
    char none_;
  };
  int32_t cells_[3];
  int16_t fraction_[3];
  bool rotated_;
  Status status_;
};

/// Fraction bits of a frame's translation: 2,048 units are one cell.
constexpr int kFrameBits = 11;
constexpr int32_t kFrameCell = 1 << kFrameBits;

/// Largest magnitude of a frame's translation along each axis, in 1/2,048 cell: 2^19 cells. The
/// difference of two translations then fits 32 bits.
constexpr int32_t kMaxFrameTranslation = 1 << 30;

/// A full turn as an angle.
constexpr int32_t kFullTurn = 1 << 28;

using Frame = flashbvh_frame;

constexpr Frame kIdentityFrame = {
    {{kRotationOne, 0, 0}, {0, kRotationOne, 0}, {0, 0, kRotationOne}}, {0, 0, 0}};

}  // namespace flashbvh
