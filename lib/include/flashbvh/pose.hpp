// Where B lies in A's frame.
#ifndef FLASHBVH_POSE_HPP
#define FLASHBVH_POSE_HPP

#include <stdint.h>

namespace flashbvh {

/// One in the fixed point of a rotation: 30 fraction bits.
constexpr int32_t kRotationOne = 1 << 30;

/// Largest magnitude of a translation, in cells: differences of origins and translations then stay
/// in 32 bits. Objects that far apart cannot touch: a mesh is at most 2 * kMaxCoordinate cells
/// wide.
constexpr int32_t kMaxTranslation = 1 << 29;

/// B's point p, in cells of B's frame, lies at rotation * p + translation in A's frame. 48 bytes.
struct Pose {
  int32_t rotation[3][3];  ///< row by row, kRotationOne is 1
  int32_t translation[3];  ///< in cells, each within +-kMaxTranslation

  /// B moved, not turned. Cells; the mesh's unit divided by the cell, rounded.
  static constexpr Pose translated(int32_t x, int32_t y, int32_t z) {
    return {{{kRotationOne, 0, 0}, {0, kRotationOne, 0}, {0, 0, kRotationOne}}, {x, y, z}};
  }

  constexpr bool is_translation() const {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        if (rotation[row][column] != (row == column ? kRotationOne : 0)) {
          return false;
        }
      }
    }
    return true;
  }
};

}  // namespace flashbvh

#endif
