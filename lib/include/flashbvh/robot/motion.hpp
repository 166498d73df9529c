// Certified motions: whether a robot is free at every moment of a straight motion between two sets
// of joint values, all joints in proportion.
//
// The query bisects the motion. In an interval's middle it tests if each pair of links is within
// the distance that the joints move it until the ends, plus Robot::slack. If not, the pair is free
// in all of the interval. If so, and if it does not intersect there, the query splits the interval.
// Source: Schwarzer, Saha and Latombe, "Adaptive Dynamic Collision Checking" (2005).
//
// Stack of run() on Cortex-M3 to M55 at -O2: 1,120 bytes.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/kinematics.hpp"
#include "flashbvh/robot/robot.hpp"
#include "flashbvh/status.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh {

/// Outcomes of a motion.
enum class MotionOutcome : uint8_t {
  free = FLASHBVH_MOTION_FREE,
  hit = FLASHBVH_MOTION_HIT,
  close = FLASHBVH_MOTION_CLOSE,
};

using MotionAnswer = flashbvh_motion_answer;

/// A query's state in addition to its arrays.
struct MotionCore {
  uint32_t robot_hash;
  Status status;
  MotionOutcome outcome;
  uint8_t level;
  uint8_t phase;
  uint16_t pair;
  uint32_t interval;  ///< starts at interval / 2^level
  TrianglePair<uint16_t> triangles;
  QueryCursor<uint16_t> cursor;
  uint32_t within;  ///< tested distance, in 1/256 cell
  Pose pose = Pose::translated(0, 0, 0);
};

/// All memory of a query: plain data without pointers. A robot's header has a MotionState.
template <uint32_t variable_count, uint32_t joint_count>
struct MotionStateOf {
  MotionCore core;
  JointCoordinate from[variable_count];
  JointCoordinate to[variable_count];
  JointCoordinate values[variable_count];
  JointCoordinate coordinates[joint_count];  ///< in the middle of an interval
  Frame frames[joint_count];
};

/// A query of one motion at a time. Its cursor is in the state.
class MotionQuery {
 public:
  /// `robot` and `state` must outlive it; start() and run() write the state.
  template <uint32_t variable_count, uint32_t joint_count>
  MotionQuery(const Robot& robot, MotionStateOf<variable_count, joint_count>& state)
      : robot_(&robot),
        core_(&state.core),
        from_(state.from),
        to_(state.to),
        values_(state.values),
        coordinates_(state.coordinates),
        frames_(state.frames),
        fit_(detail::fit_of(
            robot, variable_count >= robot.variable_count && joint_count >= robot.joint_count)) {}

  /// Takes `size` bytes instead, with the layout of a MotionStateOf of the robot's own counts.
  MotionQuery(const Robot& robot, void* memory, size_t size)
      : robot_(&robot),
        core_(static_cast<MotionCore*>(memory)),
        from_(reinterpret_cast<JointCoordinate*>(core_ + 1)),
        to_(from_ + robot.variable_count),
        values_(to_ + robot.variable_count),
        coordinates_(values_ + robot.variable_count),
        frames_(reinterpret_cast<Frame*>(coordinates_ + robot.joint_count)) {
    const auto begin = reinterpret_cast<uintptr_t>(memory);
    const auto end = reinterpret_cast<uintptr_t>(frames_ + robot.joint_count);
    fit_ = detail::fit_of(robot, begin % alignof(MotionCore) == 0 && end - begin <= size);
  }

  /// True if the robot is open and the memory is large enough for it.
  bool fits() const { return fit_ == detail::Fit::fits; }
  /// Returns `done`; `not_open`: the robot is not; `guard_state_invalid`: the memory is too small.
  Status status() const { return detail::status_of(fit_, robot_); }

  /// Starts a motion between two arrays of variable_count values. A joint without limits moves as
  /// far as the numbers differ. Both ends must be within the limits: statuses of set_coordinates(),
  /// and of status().
  Status start(const JointCoordinate* from, const JointCoordinate* to);

  /// Does at most `work` (query.hpp), overdrawn by one step; UINT32_MAX: no limit. A motion that
  /// was not started, or of another robot, is `guard_state_invalid`.
  MotionAnswer run(uint32_t work);

  /// Writes the values at numerator / 2^level of the motion, rounded to the nearest; level to 30.
  void set_values(uint32_t numerator, uint8_t level, JointCoordinate* values) const;

 private:
  void prepare();
  uint32_t way_of(const RobotJoint& joint) const;
  uint32_t reach_of_interval(uint16_t pair) const;
  void begin_interval();
  template <class QueryType>
  Status run_query(QueryType&& query, uint32_t& work);
  Status run_phase(uint32_t& work);
  void next_interval();
  void split_or_end();
  void step(uint32_t& work);

  const Robot* robot_;
  MotionCore* core_;
  JointCoordinate* from_;
  JointCoordinate* to_;
  JointCoordinate* values_;
  JointCoordinate* coordinates_;
  Frame* frames_;
  detail::Fit fit_;
};

}  // namespace flashbvh

#pragma GCC diagnostic pop
