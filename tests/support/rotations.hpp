// Rotations and poses for tests, computed in integers alone: equal on every core.
#pragma once

#include <stdint.h>

#include "flashbvh/pose.hpp"
#include "support/random.hpp"

namespace flashbvh::test {

/// A quaternion of any non-zero length, with parts within +-32,767.
struct Quaternion {
  int32_t w, x, y, z;
};

struct Rotation {
  int32_t entry[3][3];  ///< kRotationOne is 1
};

/// Calls use(row, column) for each entry.
template <class Use>
void for_entries(const Use& use) {
  for (int i = 0; i < 9; ++i) {
    use(i / 3, i % 3);
  }
}

/// The rotation of a quaternion, each entry rounded to the nearest.
inline Rotation rotation_of(const Quaternion& q) {
  const auto product = [](int32_t u, int32_t v) { return static_cast<int64_t>(u) * v; };
  const int64_t ww = product(q.w, q.w), xx = product(q.x, q.x);
  const int64_t yy = product(q.y, q.y), zz = product(q.z, q.z);
  const int64_t xy = product(q.x, q.y), zw = product(q.z, q.w), xz = product(q.x, q.z);
  const int64_t yw = product(q.y, q.w), yz = product(q.y, q.z), xw = product(q.x, q.w);
  const int64_t square = ww + xx + yy + zz;
  // A 33-bit value over a 32-bit one: shifted by 30 it fits in 64 bits without its integer part.
  const auto entry = [square](int64_t over) {
    const bool negative = over < 0;
    const int64_t size = negative ? -over : over;
    const int64_t whole = size / square;
    const int64_t rest = ((size % square) * (kRotationOne / 2) * 2 + square / 2) / square;
    const int64_t value = whole * kRotationOne + rest;
    return static_cast<int32_t>(negative ? -value : value);
  };
  return {{{entry(ww + xx - yy - zz), entry(2 * (xy - zw)), entry(2 * (xz + yw))},
           {entry(2 * (xy + zw)), entry(ww - xx + yy - zz), entry(2 * (yz - xw))},
           {entry(2 * (xz - yw)), entry(2 * (yz + xw)), entry(ww - xx - yy + zz)}}};
}

/// A random rotation: uniform, about an axis, by half a turn or a quarter, or next to one of these.
inline Quaternion any_quaternion(Random& random) {
  const auto part = [&random](int32_t most) { return random.between(-most, most); };
  Quaternion q{};
  switch (random.below(4)) {
    case 0:  // a rotation of a cube, or another one with parts of -1 to 1
      q = {part(1), part(1), part(1), part(1)};
      break;
    case 1:  // next to one of them
      q = {part(1) * 32000, part(1) * 32000, part(1) * 32000, part(1) * 32000};
      q = {q.w + part(3), q.x + part(3), q.y + part(3), q.z + part(3)};
      break;
    case 2:  // about an axis
      q.w = part(2000);
      (random.below(3) == 0 ? q.x : random.below(2) == 0 ? q.y : q.z) = part(2000);
      break;
    default:
      q = {part(20000), part(20000), part(20000), part(20000)};
  }
  return q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0 ? Quaternion{1, 0, 0, 0} : q;
}

inline Pose any_rigid_pose(Random& random, int32_t reach) {
  int32_t cells[3];
  int16_t fraction[3];
  for (int axis = 0; axis < 3; ++axis) {
    cells[axis] = random.between(-reach, reach);
    fraction[axis] = static_cast<int16_t>(random.below(2) == 0 ? 0 : random.between(-32768, 32767));
  }
  return Pose::rigid(rotation_of(any_quaternion(random)).entry, cells, fraction);
}

}  // namespace flashbvh::test
