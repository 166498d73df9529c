// Certifies motions of a robot by bisection.
#include "flashbvh/robot/motion.hpp"

#include "branch.hpp"
#include "coordinate.hpp"
#include "flashbvh/query.hpp"
#include "spheres.hpp"

namespace flashbvh {
namespace {

/// An interval of 2^-24 of the motion is not halved.
constexpr uint8_t kMostLevels = 24;

enum Phase : uint8_t { kNew, kWithin, kIntersects };

/// Work of an interval's kinematics, spheres and pose (detail/walk/work.hpp).
constexpr uint32_t kIntervalWork = 32;

}  // namespace

Status MotionQuery::start(const JointCoordinate* from, const JointCoordinate* to) {
  if (!fits()) {
    return status();
  }
  Status status = set_coordinates(*robot_, from, coordinates_);
  if (status == Status::done) {
    status = set_coordinates(*robot_, to, coordinates_);
  }
  for (uint32_t i = 0; i < robot_->variable_count; ++i) {
    from_[i] = from[i];
    to_[i] = to[i];
  }
  core_->robot_hash = robot_->hash;
  core_->outcome = MotionOutcome::free;
  core_->status = status != Status::done    ? status
                  : robot_->pair_count == 0 ? Status::done
                                            : Status::suspended;
  core_->pair = 0;
  core_->level = 0;
  core_->interval = 0;
  core_->phase = kNew;
  return status;
}

void MotionQuery::set_values(uint32_t numerator, uint8_t level, JointCoordinate* values) const {
  for (uint32_t i = 0; fits() && i < robot_->variable_count; ++i) {
    const int64_t way = static_cast<int64_t>(to_[i]) - from_[i];
    const int64_t half = level == 0 ? 0 : int64_t{1} << (level - 1);
    values[i] = static_cast<JointCoordinate>(from_[i] + ((way * numerator + half) >> level));
  }
}

/// Sets all frames for the middle of the interval.
void MotionQuery::prepare() {
  set_values(2 * core_->interval + 1, static_cast<uint8_t>(core_->level + 1), values_);
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    const RobotJoint& joint = robot_->joints[i];
    coordinates_[i] = detail::coordinate_of(joint, values_);
  }
  set_frames(*robot_, coordinates_, frames_);
}

/// Joint motion from the middle of the interval to either end, rounding included.
uint32_t MotionQuery::way_of(const RobotJoint& joint) const {
  if (joint.type == JointType::fixed) {
    return 0;
  }
  const uint64_t way = detail::apart(from_[joint.variable], to_[joint.variable]);
  const uint64_t half = (way >> (core_->level + 1)) + 2;
  if (joint.shift == 0) {
    return static_cast<uint32_t>(half);
  }
  const uint64_t mimicked = (half * detail::magnitude(joint.multiplier) >> joint.shift) + 2;
  return mimicked > UINT32_MAX ? UINT32_MAX : static_cast<uint32_t>(mimicked);
}

/// Motion of the pair from the middle of the interval to either end, in 1/256 cell.
uint32_t MotionQuery::reach_of_interval(uint16_t i) const {
  detail::Travel travel;
  detail::for_each_between(*robot_, robot_->pairs[i], [&](uint32_t joint, uint32_t reach) {
    travel.add(reach, way_of(robot_->joints[joint]));
  });
  return travel.fine();
}

/// Proceeds after an interval in which the pair is free. Next is the longest interval of the
/// bisection that begins at this one's end, or else the next pair.
void MotionQuery::next_interval() {
  ++core_->interval;
  while (core_->level != 0 && core_->interval % 2 == 0) {
    core_->interval /= 2;
    --core_->level;
  }
  if (core_->level == 0) {
    core_->interval = 0;
    ++core_->pair;
    core_->status = core_->pair < robot_->pair_count ? Status::suspended : Status::done;
  }
  core_->phase = kNew;
}

/// The pair may intersect in the interval; no intersection is known in its middle.
void MotionQuery::split_or_end() {
  core_->phase = kNew;
  if (core_->within <= 2 * robot_->slack || core_->level == kMostLevels) {
    core_->outcome = MotionOutcome::close;
    core_->status = Status::done;
    return;
  }
  core_->interval *= 2;
  ++core_->level;
}

/// Tests the spheres of an interval; if they do not decide, prepares the walk of the next phase.
void MotionQuery::begin_interval() {
  prepare();
  const RobotPair& pair = robot_->pairs[core_->pair];
  const RobotLink& a = robot_->links[pair.a];
  const RobotLink& b = robot_->links[pair.b];
  const Frame& frame_a = detail::frame_of(frames_, a.joint);
  const Frame& frame_b = detail::frame_of(frames_, b.joint);
  core_->within = detail::sum_of(reach_of_interval(core_->pair), robot_->slack);
  if (detail::sphere_gap(a, frame_a, b, frame_b) > core_->within) {
    next_interval();
  } else if (core_->within > kMaxGuardDistance) {
    split_or_end();
  } else {
    core_->pose = relative_pose(frame_a, frame_b);
    core_->cursor = {};
    core_->phase = kWithin;
  }
}

/// Runs a slice of the phase's query; returns `full` if the answer is yes.
template <class QueryType>
Status MotionQuery::run_query(QueryType&& query, uint32_t& work) {
  const Status status = query.resume(core_->cursor);
  if (status != Status::suspended) {
    return status;
  }
  const RunResult step = query.run(work, [&](const TrianglePair<uint16_t>& pair) {
    core_->triangles = pair;
    return false;
  });
  work -= step.work;
  core_->cursor = query.cursor();
  return step.status;
}

Status MotionQuery::run_phase(uint32_t& work) {
  const RobotPair& pair = robot_->pairs[core_->pair];
  const Mesh& a = robot_->meshes[pair.a];
  const Mesh& b = robot_->meshes[pair.b];
  return core_->phase == kWithin
             ? run_query(WithinQuery(a, b, core_->pose, {}, within({core_->within})), work)
             : run_query(PairQuery(a, b, core_->pose), work);
}

/// Begins an interval, or runs a slice of a query.
void MotionQuery::step(uint32_t& work) {
  if (core_->phase == kNew) {
    detail::take_work(work, kIntervalWork);
    begin_interval();
    return;
  }
  const Status status = run_phase(work);
  if (status == Status::done && core_->phase == kWithin) {
    next_interval();
  } else if (status == Status::done || status == Status::distance_out_of_range) {
    split_or_end();  // also if the pair is too far apart for a query with this distance
  } else if (status == Status::full && core_->phase == kWithin) {
    core_->cursor = {};
    core_->phase = kIntersects;
  } else if (status == Status::full) {
    core_->outcome = MotionOutcome::hit;
    core_->status = Status::done;
  } else if (status != Status::suspended) {
    core_->status = status;
  }
}

/// Terminates with unlimited work: each iteration advances a query, and each query's end halves the
/// interval or proceeds to the next one. No interval is halved more than kMostLevels times.
MotionAnswer MotionQuery::run(uint32_t work) {
  if (!fits() || core_->robot_hash != robot_->hash) {
    const Status why = status();
    return {
        why == Status::done ? Status::guard_state_invalid : why, MotionOutcome::close, 0, {}, 0, 0};
  }
  while (core_->status == Status::suspended && work != 0) {
    step(work);
  }
  return {core_->status,    core_->outcome,          core_->pair,
          core_->triangles, 2 * core_->interval + 1, static_cast<uint8_t>(core_->level + 1)};
}

}  // namespace flashbvh
