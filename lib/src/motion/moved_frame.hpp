// Frames that move: the kinematics of a motion of moves.
#ifndef FLASHBVH_MOTION_MOVED_FRAME_HPP
#define FLASHBVH_MOTION_MOVED_FRAME_HPP

#include <stdint.h>

#include "flashbvh/body_motion.hpp"
#include "flashbvh/frame.hpp"

namespace flashbvh::detail {

/// Its translation to the nearest 1/2,048 cell.
Frame frame_of(const Pose& pose);
Pose pose_of(const Frame& frame);

/// A frame that a move has carried until `time`. The rotation is off by at most 2^-24 in norm; the
/// translation by so much of its distance from the axis' point, and 2^-11 cell.
void carry(const Move& move, uint32_t time, Frame& frame);

/// Where B's frame is.
Frame frame_at(const BodyMotion& motion, uint32_t time);
/// How far from A's origin a point may get that is so far at first, in 1/2,048 cell.
uint64_t farthest(const BodyMotion& motion, uint64_t at_first);

/// A point of a frame: exact to 1/2,048 cell, in which the point is, too.
struct FramePoint {
  int64_t axis[3];
};
FramePoint place(const Frame& frame, const int32_t (&point)[3]);

/// How far a point is from the axis of a move that has not begun, in 1/2,048 cell, rounded up.
uint32_t distance_from_axis(const Move& move, const FramePoint& point);

/// Of a vector in 1/2,048 cell, rounded up.
uint32_t length_of(const int32_t (&vector)[3]);

}  // namespace flashbvh::detail

#endif
