// Motions of a body with a free pose: where B lies in A's frame at each moment.
//
// A motion is a pose to begin with and moves, each of which turns the body about an axis and
// travels with it: so a straight way, a screw, or any chain of joints. Each move is carried by
// those before it, as a joint is by its parent, and all go from their begin to their end together,
// at constant speed.
#ifndef FLASHBVH_BODY_MOTION_HPP
#define FLASHBVH_BODY_MOTION_HPP

#include <stdint.h>

#include "flashbvh/frame.hpp"
#include "flashbvh/plain/motion_parts.h"
#include "flashbvh/pose.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

using Move = flashbvh_move;

/// The end of a motion. A time is a binary fraction of it, 0 its begin.
constexpr uint32_t kMotionEnd = 1u << 30;
/// How far the square of an axis' length may be from 1, in the fixed point of a rotation: 2^-13. It
/// is normalised.
constexpr int32_t kAxisTolerance = kRotationOne >> 13;

/// Plain data: constant once made, and shared by any number of queries. 188 bytes on a 32-bit core.
class BodyMotion {
 public:
  /// From one pose to another: the origin of B's frame goes straight, and B turns about it at
  /// constant speed, the shorter way; by half a turn, either way. Both ends are as given. The way
  /// is the moves' own: where matrices are not exactly rotations, it ends a little off `to`, and
  /// FirstContact counts that as distance.
  /// Instructions on a Cortex-M4 at -O2: 4,700; of translations 1,600 (lib/docs/figures.md).
  static BodyMotion between(const Pose& from, const Pose& to);

  /// By `count` moves, which outlive the motion, from the outermost to the innermost: of a chain of
  /// joints, from the base to the body. Of an arm that carries A: its moves, reversed in order and
  /// in sign, before those of B. `not_a_rotation`: an axis' length is not 1.
  BodyMotion(const Pose& from, const Move* moves, uint32_t count);

  /// `done`, or why no query can use it; of poses their own. `motion_out_of_range`: B's origin may
  /// get farther than 2^19 cells from A's frame, by the sum of the lengths of all numbers, those of
  /// points twice.
  Status status() const { return status_; }

  /// Where B lies at `time`, up to kMotionEnd: at both ends as given or made, and between within
  /// 2^-6 cell of the exact way. Instructions on a Cortex-M4 at -O2 for one move: 1,000 if it
  /// turns, else 650 (lib/docs/figures.md).
  Pose pose_at(uint32_t time) const;

  /// From the outermost to the innermost; 1 between two poses.
  uint32_t move_count() const { return count_; }
  /// `i`: below move_count().
  const Move& move(uint32_t i) const { return moves_ == nullptr ? own_ : moves_[i]; }
  /// Where B lies at its begin.
  const Pose& from() const { return from_; }
  /// Where B lies at its end.
  const Pose& to() const { return to_; }

 private:
  BodyMotion(const Pose& from, const Pose& to);
  void check();

  Pose from_;
  Pose to_;
  const Move* moves_;  ///< null: `own_`
  Move own_;
  uint32_t count_;
  Status status_;
};

}  // namespace flashbvh

#endif
