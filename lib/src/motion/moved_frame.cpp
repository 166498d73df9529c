// Kinematics of moves, in integers with 64-bit products.
#include "moved_frame.hpp"

#include "../lattice/fixed_point.hpp"
#include "../lattice/sine.hpp"
#include "flashbvh/detail/predicates/fraction.hpp"

namespace flashbvh::detail {
namespace {

/// Rotation about an axis: R = c + s [u] + (1 - c) u u^T, with u normalised by one Newton step.
void set_rotation(const Move& move, uint32_t time, int32_t (&rotation)[3][3]) {
  const auto turned = static_cast<uint32_t>((int64_t{move.turn} * time) >> 26);
  const SineCosine at = sine_cosine(turned);
  const auto& given = move.axis;
  const int64_t squared = fixed_product(given[0], given[0]) + fixed_product(given[1], given[1]) +
                          fixed_product(given[2], given[2]);
  const auto short_by = static_cast<int32_t>(kRotationOne - (squared >> 30)) / 2;
  int32_t u[3];
  int32_t sine[3];
  for (int i = 0; i < 3; ++i) {
    u[i] = given[i] + fixed_rounded(fixed_product(given[i], short_by));
    sine[i] = fixed_rounded(fixed_product(u[i], at.sine));
  }
  for (int i = 0; i < 3; ++i) {
    const int64_t versed = (u[i] * (int64_t{kRotationOne} - at.cosine)) >> 30;
    rotation[i][i] = static_cast<int32_t>(at.cosine + (versed * u[i] >> 30));
    const int j = i == 2 ? 0 : i + 1;
    const int k = 3 - i - j;
    const auto both = static_cast<int32_t>(versed * u[j] >> 30);
    rotation[i][j] = both - sine[k];
    rotation[j][i] = both + sine[k];
  }
}

int32_t travelled(int32_t length, uint32_t time) {
  return static_cast<int32_t>((int64_t{length} * time + (kMotionEnd >> 1)) >> 30);
}

}  // namespace

Frame frame_of(const Pose& pose) {
  Frame frame;
  constexpr int dropped = 16 - kFrameBits;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      frame.rotation[i][j] = pose.rotation(i, j);
    }
    frame.translation[i] =
        pose.translation(i) * kFrameCell + ((pose.fraction(i) + (1 << (dropped - 1))) >> dropped);
  }
  return frame;
}

Pose pose_of(const Frame& frame) {
  int32_t cells[3];
  int16_t fraction[3];
  for (int i = 0; i < 3; ++i) {
    const int32_t t = frame.translation[i];
    cells[i] = (t + kFrameCell / 2) >> kFrameBits;
    fraction[i] = static_cast<int16_t>((t - cells[i] * kFrameCell) * (1 << (16 - kFrameBits)));
  }
  return Pose::rigid(frame.rotation, cells, fraction);
}

void carry(const Move& move, uint32_t time, Frame& frame) {
  if (move.turn != 0) {
    int32_t turned[3][3];
    set_rotation(move, time, turned);
    const Frame before = frame;
    for (int i = 0; i < 3; ++i) {
      int64_t moved = 0;
      for (int j = 0; j < 3; ++j) {
        moved += turned[i][j] * (int64_t{before.translation[j]} - move.point[j]);
        frame.rotation[i][j] = fixed_rounded(fixed_product(turned[i][0], before.rotation[0][j]) +
                                             fixed_product(turned[i][1], before.rotation[1][j]) +
                                             fixed_product(turned[i][2], before.rotation[2][j]));
      }
      frame.translation[i] = move.point[i] + fixed_rounded(moved);
    }
  }
  for (int i = 0; i < 3; ++i) {
    frame.translation[i] += travelled(move.travel[i], time);
  }
}

FramePoint place(const Frame& frame, const int32_t (&point)[3]) {
  FramePoint placed;
  for (int i = 0; i < 3; ++i) {
    const auto& row = frame.rotation[i];
    placed.axis[i] = int64_t{frame.translation[i]} + fixed_rounded(fixed_product(row[0], point[0]) +
                                                                   fixed_product(row[1], point[1]) +
                                                                   fixed_product(row[2], point[2]));
  }
  return placed;
}

uint32_t distance_from_axis(const Move& move, const FramePoint& point) {
  int64_t from[3];
  for (int i = 0; i < 3; ++i) {
    from[i] = point.axis[i] - move.point[i];
  }
  uint64_t squared = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    const int k = 3 - i - j;
    const int64_t across = (move.axis[j] * from[k] - move.axis[k] * from[j]) >> 30;
    squared += static_cast<uint64_t>(across * across);
  }
  // The axis may be too short by 2^-14 of its length; 3 covers rounding of components and root.
  const uint32_t length = square_root(squared);
  return length + (length >> 13) + 3;
}

uint32_t length_of(const int32_t (&vector)[3]) {
  uint64_t squared = 0;
  for (const int32_t along : vector) {
    squared += static_cast<uint64_t>(fixed_product(along, along));
  }
  return squared == 0 ? 0 : square_root(squared) + 1;
}

}  // namespace flashbvh::detail
