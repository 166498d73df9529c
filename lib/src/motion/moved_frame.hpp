// Kinematics of a motion that is a product of moves.
#pragma once

#include <stdint.h>

#include "flashbvh/first_contact.hpp"
#include "flashbvh/pose.hpp"

namespace flashbvh::detail {

/// Rounds the translation to the nearest 1/2,048 cell.
Frame frame_of(const Pose& pose);
Pose pose_of(const Frame& frame);

/// Moves a frame by a move's share until `time`. The rotation's error is at most 2^-24 in norm, the
/// translation's 2^-24 of its distance from the axis' point, and 2^-11 cell.
void carry(const Move& move, uint32_t time, Frame& frame);

/// Returns B's frame at a time.
Frame frame_at(const BodyMotion& motion, uint32_t time);
/// Upper bound on the distance from A's origin that a point at distance `at_first` reaches during
/// the motion, in 1/2,048 cell.
uint64_t farthest(const BodyMotion& motion, uint64_t at_first);

/// A point in A's frame, in 1/2,048 cell, rounded to that unit.
struct FramePoint {
  int64_t axis[3];
};
FramePoint place(const Frame& frame, const int32_t (&point)[3]);

/// Distance of a point from a move's axis at the move's begin, in 1/2,048 cell, rounded up.
uint32_t distance_from_axis(const Move& move, const FramePoint& point);

/// Length of a vector in 1/2,048 cell, rounded up.
uint32_t length_of(const int32_t (&vector)[3]);

}  // namespace flashbvh::detail
