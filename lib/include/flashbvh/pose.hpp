// Where B lies in A's frame: a rotation in fixed point and a translation in cells.
#ifndef FLASHBVH_POSE_HPP
#define FLASHBVH_POSE_HPP

#include <stdint.h>

#include "flashbvh/split_matrix.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// One in the fixed point of a rotation: 30 fraction bits.
constexpr int32_t kRotationOne = 1 << 30;

/// How far R^T R may be from the identity, entry by entry, for R to count as a rotation: 2^-13, in
/// the fixed point of a rotation. A matrix written with five decimals passes; of those with four,
/// not all.
constexpr int32_t kRotationTolerance = kRotationOne >> 13;

/// Largest magnitude of a translation, in cells: differences of origins and translations then stay
/// in 32 bits. Objects that far apart cannot touch: a mesh is at most 2 * kMaxCoordinate cells
/// wide.
constexpr int32_t kMaxTranslation = 1 << 29;

/// B's point p, in cells of B's frame, lies at rotation * p + translation in A's frame. 104 bytes:
/// all that a query needs and that depends on the pose alone is worked out here, once.
///
/// Checked when it is made, so that a query need not: a pose that can't be is kept as an error,
/// which every query on it returns, and every pose made of it.
class Pose {
 public:
  /// B moved, not turned. Cells: the mesh's unit divided by the cell, rounded. Beyond
  /// +-kMaxTranslation the pose's status is `translation_out_of_range`.
  static constexpr Pose translated(int32_t x, int32_t y, int32_t z) { return Pose(x, y, z); }

  /// B turned and moved. `rotation`: row by row, kRotationOne is 1; kept to 2^-22. `cells`: the
  /// translation, rounded to whole cells; `fraction`: what rounding left, in 1/65,536 of a cell,
  /// -32,768 to 32,767. A matrix further than kRotationTolerance from a rotation, or a mirroring
  /// one, gives `not_a_rotation`; within it is used as it is, not mended.
  static Pose rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3],
                    const int16_t (&fraction)[3]);
  static Pose rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3]);

  /// First `inner`, then `outer`: B in A's frame from B in C's and C in A's. Each entry of the
  /// rotation is rounded to 2^-22, the translation to 2^-16 cells. Tolerances add up: a product of
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
  constexpr int32_t rotation(int row, int column) const {
    return fine(row, column) * (1 << (30 - kFineBits));
  }

  /// Whether the rotation is exactly the identity.
  constexpr bool is_translation() const { return !turned_; }

  /// What turned poses alone have.
  ///
  /// The rotation with kSplitBits fraction bits, for boxes: `rows` turn B's into A's frame,
  /// `columns` A's into B's.
  constexpr const SplitMatrix& rows() const { return matrix_.rows; }
  constexpr const SplitMatrix& columns() const { return matrix_.columns; }
  /// What `rows` lack of the full rotation, in 2^-22: -128 to 127.
  constexpr int32_t rest(int row, int column) const { return matrix_.rest[row][column]; }
  /// How far R^T R is from the identity at most, entry by entry: 24 fraction bits, rounded up.
  constexpr uint32_t defect() const { return matrix_.defect; }

 private:
  /// Fraction bits kept of a rotation.
  static constexpr unsigned kFineBits = 22;

  struct Matrix {
    SplitMatrix rows;
    SplitMatrix columns;
    int8_t rest[3][3];
    uint16_t defect;
  };

  constexpr Pose(int32_t x, int32_t y, int32_t z)
      : none_(),
        cells_{x, y, z},
        fraction_{0, 0, 0},
        turned_(false),
        status_(in_range(x) && in_range(y) && in_range(z) ? Status::done
                                                          : Status::translation_out_of_range) {}

  static constexpr bool in_range(int32_t t) {
    constexpr uint32_t most = kMaxTranslation;
    return static_cast<uint32_t>(t) + most <= 2 * most;
  }

  /// An entry of the rotation, with kFineBits fraction bits.
  constexpr int32_t fine(int row, int column) const {
    if (!turned_) {
      return row == column ? 1 << kFineBits : 0;
    }
    const SplitRow& r = matrix_.rows.row[row];
    const int32_t coarse = column == 0 ? r.x() : column == 1 ? r.y() : r.z_entry();
    return coarse * (1 << (kFineBits - kSplitBits)) + matrix_.rest[row][column];
  }

  /// With kFineBits fraction bits.
  void set_rotation(const int32_t (&rotation)[3][3]);
  /// A component of the translation: cells, and 1/65,536 of cells, both with kFineBits fraction
  /// bits.
  void set_translation(int axis, int64_t cells, int64_t fractions);

  union {
    Matrix matrix_;  ///< if turned
    char none_;
  };
  int32_t cells_[3];
  int16_t fraction_[3];
  bool turned_;
  Status status_;
};

}  // namespace flashbvh

#endif
