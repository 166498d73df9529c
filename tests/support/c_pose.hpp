// A pose in both languages.
#pragma once

#include <cstring>

#include "flashbvh/flashbvh.h"
#include "flashbvh/pose.hpp"

namespace flashbvh::test {

/// Whether both have this status and, without an error, equal numbers.
inline bool same(const flashbvh_pose& c, const Pose& pose) {
  Pose held = pose;
  static_assert(sizeof held == sizeof c, "C's pose holds a pose");
  std::memcpy(static_cast<void*>(&held), &c, sizeof held);
  bool agree = held.status() == pose.status();
  for (int i = 0; agree && pose.status() == Status::done && i < 9; ++i) {
    agree = held.rotation(i / 3, i % 3) == pose.rotation(i / 3, i % 3) &&
            held.translation(i % 3) == pose.translation(i % 3) &&
            held.fraction(i % 3) == pose.fraction(i % 3);
  }
  return agree;
}

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

}  // namespace flashbvh::test
