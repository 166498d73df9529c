// Motions of a body with a free pose: B's pose in A's frame at each moment.
//
// A motion is a start pose and moves. Each move turns the body about an axis and translates it with
// the axis: a straight path, a screw, or a chain of joints. Each move is relative to the moves
// before it, like a joint to its parent. All start and end together and run at constant speed.
#ifndef FLASHBVH_BODY_MOTION_HPP
#define FLASHBVH_BODY_MOTION_HPP

#include <stdint.h>

#include "flashbvh/frame.hpp"
#include "flashbvh/plain/motion_parts.h"
#include "flashbvh/pose.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

using Move = flashbvh_move;

/// The end of a motion. A time is a binary fraction of the motion; 0 is the start.
constexpr uint32_t kMotionEnd = 1u << 30;
/// Tolerance of an axis: its squared length may differ from 1 by 2^-13, in the fixed point of a
/// rotation. The motion normalises the axis.
constexpr int32_t kAxisTolerance = kRotationOne >> 13;

/// Plain data, constant once made; any number of queries may share it. 188 bytes on a 32-bit core.
class BodyMotion {
 public:
  /// Returns the motion from one pose to another. B's origin moves straight, and B turns about it
  /// at constant speed the shorter way; by half a turn, either way. Both ends are as given. The
  /// path follows the moves: if matrices are not exact rotations, it ends slightly off `to`, and
  /// FirstContact adds that to the distance. Instructions on a Cortex-M4 at -O2: 4,700; for
  /// translations 1,600 (lib/docs/figures.md).
  static BodyMotion between(const Pose& from, const Pose& to);

  /// Makes a motion of `count` moves, which must outlive it, from the outermost to the innermost:
  /// for a chain of joints, from the base to the body. If an arm carries A, A's moves come before
  /// B's, in reverse order and with reverse signs. `not_a_rotation`: an axis' length is not 1.
  BodyMotion(const Pose& from, const Move* moves, uint32_t count);

  /// `done`, or the error that queries return; for poses, their own. `motion_out_of_range`: B's
  /// origin may get farther than 2^19 cells from A's frame, by the sum of the lengths of all
  /// translations and points, points counted twice.
  Status status() const { return status_; }

  /// Returns B's pose at `time`, up to kMotionEnd: as given or made at both ends, in between within
  /// 2^-6 cell of the exact path. Instructions on a Cortex-M4 at -O2 for one move: 1,000 if it
  /// turns, else 650 (lib/docs/figures.md).
  Pose pose_at(uint32_t time) const;

  /// Returns the number of moves; 1 between two poses.
  uint32_t move_count() const { return count_; }
  /// Returns a move, from the outermost to the innermost. `i`: below move_count().
  const Move& move(uint32_t i) const { return moves_ == nullptr ? own_ : moves_[i]; }
  /// Returns B's pose at the start.
  const Pose& from() const { return from_; }
  /// Returns B's pose at the end.
  const Pose& to() const { return to_; }

 private:
  BodyMotion(const Pose& from, const Pose& to);
  void check();

  Pose from_;
  Pose to_;
  const Move* moves_;  ///< null: `own_` is the move
  Move own_;
  uint32_t count_;
  Status status_;
};

}  // namespace flashbvh

#endif
