// Where B lies in A's frame.
#ifndef FLASHBVH_POSE_HPP
#define FLASHBVH_POSE_HPP

#include <stdint.h>

#include "flashbvh/status.hpp"

namespace flashbvh {

/// One in the fixed point of a rotation: 30 fraction bits.
constexpr int32_t kRotationOne = 1 << 30;

/// Largest magnitude of a translation, in cells: differences of origins and translations then stay
/// in 32 bits. Objects that far apart cannot touch: a mesh is at most 2 * kMaxCoordinate cells
/// wide.
constexpr int32_t kMaxTranslation = 1 << 29;

/// B's point p, in cells of B's frame, lies at rotation * p + translation in A's frame. 52 bytes.
///
/// Checked when it is made, so that a query need not: a pose that can't be is kept as an error,
/// which every query on it returns. In this version poses are translations.
class Pose {
 public:
  /// B moved, not turned. Cells: the mesh's unit divided by the cell, rounded. Beyond
  /// +-kMaxTranslation the pose's status is `translation_out_of_range`.
  static constexpr Pose translated(int32_t x, int32_t y, int32_t z) { return Pose(x, y, z); }

  /// `done` if queries can use the pose, else why not.
  constexpr Status status() const { return status_; }

  /// In cells. `axis`: 0 to 2.
  constexpr int32_t translation(int axis) const { return translation_[axis]; }
  /// kRotationOne is 1. `row` and `column`: 0 to 2.
  constexpr int32_t rotation(int row, int column) const { return rotation_[row][column]; }

 private:
  constexpr Pose(int32_t x, int32_t y, int32_t z)
      : rotation_{{kRotationOne, 0, 0}, {0, kRotationOne, 0}, {0, 0, kRotationOne}},
        translation_{x, y, z},
        status_(in_range(x) && in_range(y) && in_range(z) ? Status::done
                                                          : Status::translation_out_of_range) {}

  static constexpr bool in_range(int32_t t) {
    constexpr uint32_t most = kMaxTranslation;
    return static_cast<uint32_t>(t) + most <= 2 * most;
  }

  int32_t rotation_[3][3];  ///< row by row
  int32_t translation_[3];
  Status status_;
};

}  // namespace flashbvh

#endif
