// A pose in both languages.
#pragma once

#include "flashbvh/flashbvh.h"
#include "flashbvh/pose.hpp"

namespace flashbvh::test {

/// The pose in C, with equal numbers.
inline flashbvh_pose c_pose_of(const Pose& pose) {
  int32_t rotation[9];
  int32_t cells[3];
  int16_t fraction[3];
  flashbvh_pose made;
  for (int i = 0; i < 9; ++i) {
    rotation[i] = pose.rotation(i / 3, i % 3);
    cells[i % 3] = pose.translation(i % 3);
    fraction[i % 3] = static_cast<int16_t>(pose.fraction(i % 3));
  }
  (void)flashbvh_pose_rigid(rotation, cells, fraction, &made);
  return made;
}

/// Whether status and, without an error, all numbers are equal.
inline bool same(const flashbvh_pose& c, const Pose& pose) {
  int32_t rotation[9];
  int32_t cells[3];
  int16_t fraction[3];
  flashbvh_pose_values(&c, rotation, cells, fraction);
  bool agree = flashbvh_pose_status(&c) == static_cast<flashbvh_status>(pose.status());
  for (int i = 0; agree && pose.status() == Status::done && i < 9; ++i) {
    agree = rotation[i] == pose.rotation(i / 3, i % 3) && cells[i % 3] == pose.translation(i % 3) &&
            fraction[i % 3] == pose.fraction(i % 3);
  }
  return agree;
}

}  // namespace flashbvh::test
