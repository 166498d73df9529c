// A pose made of an input's bytes: any translation, and any rotation or none.
#pragma once

#include "fuzz/fuzz.hpp"
#include "support/rotations.hpp"

namespace flashbvh::test {

/// The arguments of a pose's constructor.
struct PoseNumbers {
  bool is_turned = false;
  std::int32_t rotation[3][3] = {};  ///< rarely a rotation
  std::int32_t cells[3] = {};
  std::int16_t fraction[3] = {};

  /// The pose in C++.
  Pose pose() const {
    return is_turned ? Pose::rigid(rotation, cells, fraction)
                     : Pose::translated(cells[0], cells[1], cells[2]);
  }
};

inline PoseNumbers any_pose_numbers(Input& input) {
  PoseNumbers numbers;
  const auto kind = input.take<std::uint8_t>();
  for (int axis = 0; axis < 3; ++axis) {
    // A small translation, or any.
    numbers.cells[axis] = (kind & 1) != 0 ? input.take<std::int32_t>() : input.take<std::int16_t>();
    numbers.fraction[axis] = input.take<std::int16_t>();
  }
  numbers.is_turned = (kind & 2) == 0;
  if (numbers.is_turned && (kind & 4) != 0) {
    for (auto& row : numbers.rotation) {
      for (std::int32_t& entry : row) {
        entry = input.take<std::int32_t>();
      }
    }
  } else if (numbers.is_turned) {
    const auto part = [&input] { return std::int32_t{input.take<std::int16_t>()} / 2; };
    Quaternion q = {part(), part(), part(), part()};
    q.w += q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0 ? 1 : 0;
    const Rotation matrix = rotation_of(q);
    std::memcpy(numbers.rotation, matrix.entry, sizeof numbers.rotation);
  }
  return numbers;
}

inline Pose any_pose(Input& input) {
  return any_pose_numbers(input).pose();
}

}  // namespace flashbvh::test
