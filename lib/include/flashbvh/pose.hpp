// Where B lies in A's frame: a rotation in fixed point and a translation in cells.
#ifndef FLASHBVH_POSE_HPP
#define FLASHBVH_POSE_HPP

#include <stdint.h>

#include "flashbvh/detail/lattice/split_matrix.hpp"
#include "flashbvh/status.hpp"

/// Poses are made with vectors, too (lib/src/lattice/pose_sse2.hpp).
#if defined(__SSE2__) && defined(__x86_64__) && !defined(FLASHBVH_PORTABLE)
#define FLASHBVH_POSE_SSE2 1
#endif

namespace flashbvh {

namespace detail {
struct PoseOfLanes;
}

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

/// B's point p, in cells of B's frame, lies at rotation * p + translation in A's frame. 68 bytes.
///
/// Checked when it is made, so that a query need not: a pose that can't be is kept as an error,
/// which every query on it returns, and every pose made of it. Constant once made: queries, tasks
/// and interrupts may share it; to write one while another reads it takes a lock of the caller's.
///
/// Instructions on a Cortex-M4 at -O2, which lib/docs/figures.md has for every core: rigid() 580,
/// relative() 1,060, composed() and inverse() less. Stack in bytes, on Cortex-M3 to M55 at -O2:
/// rigid() 112, inverse() 176, composed() and relative() 288.
class Pose {
 public:
  /// B translated, not rotated. Cells: the mesh's unit divided by the cell, rounded. Beyond
  /// +-kMaxTranslation the pose's status is `translation_out_of_range`.
  static constexpr Pose translated(int32_t x, int32_t y, int32_t z) { return Pose(x, y, z); }

  /// B rotated and translated. `rotation`: row by row, kRotationOne is 1; kept to 2^-22. `cells`:
  /// the translation, rounded to whole cells; `fraction`: what rounding left, in 1/65,536 of a
  /// cell, -32,768 to 32,767. A matrix further than kRotationTolerance from a rotation, or a
  /// mirroring one, gives `not_a_rotation`; within it is used as it is, not repaired.
  static Pose rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3],
                    const int16_t (&fraction)[3]);
  /// The same, translated by whole cells.
  static Pose rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3]);

  /// These three know how far their factors' matrices are from rotations, and do not work it out
  /// again for the product: queries may make a few visits more than under the same numbers given to
  /// rigid(), and give the same answers.
  ///
  /// First `inner`, then `outer`: B in A's frame from B in C's and C in A's. Each entry of the
  /// rotation is rounded to 2^-22, the translation to 2^-16 cells. Tolerances add up: a product of
  /// inexact matrices may be `not_a_rotation`.
  static Pose composed(const Pose& outer, const Pose& inner);

  /// A in B's frame from B in A's: the transposed matrix.
  Pose inverse() const;

  /// B in A's frame from both in the world's; rounded once, as composed().
  static Pose relative(const Pose& world_a, const Pose& world_b);

  /// `done` if queries can use the pose, else why not.
  constexpr Status status() const { return status_; }

  /// In cells, rounded to the nearest. `axis`: 0 to 2.
  constexpr int32_t translation(int axis) const { return cells_[axis]; }
  /// What is left of it, in 1/65,536 of a cell: -32,768 to 32,767.
  constexpr int32_t fraction(int axis) const { return fraction_[axis]; }
  /// kRotationOne is 1. `row` and `column`: 0 to 2.
  constexpr int32_t rotation(int row, int column) const {
    if (!rotated_) {
      return row == column ? kRotationOne : 0;
    }
    int32_t entry[3] = {};
    matrix_.get_row(row, entry[0], entry[1], entry[2]);
    return entry[column] * (1 << (30 - detail::kRotationBits));
  }

  /// Whether the rotation is exactly the identity.
  constexpr bool is_translation() const { return !rotated_; }

  /// For the library: the rotation, of a pose that has one.
  constexpr const detail::RotationMatrix& matrix() const { return matrix_; }

 private:
  using Entries = int32_t[3][3];  ///< with kRotationBits fraction bits
  friend struct detail::PoseOfLanes;

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
  /// The product of rotations with these defects, `right` transposed: proven again only where their
  /// sum is much.
  void set_product(const Entries& left, const Entries& right, uint32_t defects);
  void refuse(Status status) { status_ = status_ == Status::done ? status : status_; }
  /// left * (cells, fraction), and what it is added to.
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

}  // namespace flashbvh

#endif
