// A pose made of an input's bytes: any translation, and any rotation or none.
#pragma once

#include "fuzz/fuzz.hpp"
#include "support/rotations.hpp"

namespace flashbvh::test {

inline Pose any_pose(Input& input) {
  const auto kind = input.take<std::uint8_t>();
  std::int32_t cells[3];
  std::int16_t fraction[3];
  for (int axis = 0; axis < 3; ++axis) {
    // A small translation, or any.
    cells[axis] = (kind & 1) != 0 ? input.take<std::int32_t>() : input.take<std::int16_t>();
    fraction[axis] = input.take<std::int16_t>();
  }
  if ((kind & 2) != 0) {
    return Pose::translated(cells[0], cells[1], cells[2]);
  }
  if ((kind & 4) != 0) {
    Rotation matrix{};  // rarely a rotation
    for (auto& row : matrix.entry) {
      for (std::int32_t& entry : row) {
        entry = input.take<std::int32_t>();
      }
    }
    return Pose::rigid(matrix.entry, cells, fraction);
  }
  const auto part = [&input] { return std::int32_t{input.take<std::int16_t>()} / 2; };
  Quaternion q = {part(), part(), part(), part()};
  q.w += q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0 ? 1 : 0;
  return Pose::rigid(rotation_of(q).entry, cells, fraction);
}

}  // namespace flashbvh::test
