// The guard: decides which certificates still hold. guard_measure.cpp renews certificates.
#include "flashbvh/robot/guard.hpp"

#include "branch.hpp"
#include "coordinate.hpp"
#include "guard_parts.hpp"
#include "levers.hpp"

namespace flashbvh {

using detail::difference_of;
using detail::greater;
using detail::kPeriodsAhead;
using detail::kRateMargin;
using detail::sum_of;

namespace {

constexpr uint32_t kStateVersion = 5;

constexpr GuardPair kUnknown = {0, UINT32_MAX, 0, {0, 0}, 0, kNoFloor, kNotMeasured};

constexpr bool is_unknown(const GuardPair& pair) {
  return pair.lower == 0 && pair.upper == UINT32_MAX;
}

/// Returns whether the certificate might expire soon if all joints moved as fast as the fastest.
bool is_near(uint32_t left, const RobotPair& pair, uint32_t longest_step) {
  const uint64_t most = static_cast<uint64_t>(pair.reach) * longest_step >> kReachBits;
  return left <= (most + 1) * kPeriodsAhead;
}

}  // namespace

uint32_t Guard::joints_between() const {
  uint32_t count = 0;
  for (uint32_t i = 0; i < robot_->pair_count; ++i) {
    count += robot_->pairs[i].joints_a + robot_->pairs[i].joints_b;
  }
  return count;
}

void Guard::forget() {
  if (!fits()) {
    return;
  }
  core_->version = kStateVersion;
  core_->laps = 0;
  core_->robot_hash = robot_->hash;
  core_->checksum = 0;
  core_->walked_pair = kNoPair;
  core_->has_values = 0;
  core_->roaming = 0;
  core_->share = 0;
  core_->rounding = rounding();
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    before_[i] = step_[i] = granted_[i] = 0;
    tried_[i] = kNoCoordinate;
  }
  for (uint32_t i = 0; i < robot_->pair_count; ++i) {
    pairs_[i] = kUnknown;
  }
  for (uint32_t i = joints_between(); i-- != 0;) {
    certified_[i] = 0;
    shares_[i] = detail::kWholeReach;
  }
}

/// Returns whether the guard is one of this robot and has had a period.
bool Guard::has_values() const {
  return fits() && core_->has_values != 0 && core_->robot_hash == robot_->hash;
}

/// The status of a guard without values.
Status Guard::refusal() const {
  const Status why = status();
  return why == Status::done ? Status::guard_state_invalid : why;
}

/// Returns whether all indices of the state are in the robot's arrays, and all numbers in range.
bool Guard::is_possible() const {
  if (!has_values() || core_->version != kStateVersion) {
    return false;
  }
  const uint16_t walked = core_->walked_pair;
  bool is_valid =
      walked == kNoPair || (walked < robot_->pair_count && has_triangles(walked, core_->witness));
  for (uint16_t i = 0; is_valid && i < robot_->pair_count; ++i) {
    is_valid = pairs_[i].lower <= pairs_[i].upper && has_triangles(i, pairs_[i].witness);
  }
  for (uint32_t i = 0; is_valid && i < robot_->joint_count; ++i) {
    const RobotJoint& joint = robot_->joints[i];
    const JointCoordinate now = detail::difference(before_[i], detail::difference(0, step_[i]));
    is_valid = detail::can_be_at(joint, before_[i]) && detail::can_be_at(joint, now) &&
               detail::can_be_at(joint, granted_[i]) &&
               (walked == kNoPair || detail::can_be_at(joint, walked_[i]));
  }
  return is_valid;
}

bool Guard::has_triangles(uint16_t i, const Witness<uint16_t>& witness) const {
  const RobotPair& pair = robot_->pairs[i];
  return witness.a < robot_->meshes[pair.a].triangle_count &&
         witness.b < robot_->meshes[pair.b].triangle_count;
}

Status Guard::resume() {
  if (!is_possible()) {
    forget();
    return refusal();
  }
  core_->rounding = rounding();
  forget_obstacles();  // they may have moved without a count: their workcell may be a new one
  if (core_->walked_pair != kNoPair) {  // the stored pose is not checked but made again
    set_frames(*robot_, walked_, frames_);
    core_->pose = pose_of(robot_->pairs[core_->walked_pair]);
  }
  core_->has_frames = 0;
  return Status::done;
}

/// Returns whether the link is an obstacle, which Workcell::move() may move.
bool Guard::is_obstacle(uint8_t link) const {
  const uint8_t joint = robot_->links[link].joint;
  return joint != kBase && robot_->joints[joint].type == JointType::fixed &&
         robot_->joints[joint].parent == kBase;
}

bool Guard::has_obstacle(uint16_t i) const {
  return is_obstacle(robot_->pairs[i].a) || is_obstacle(robot_->pairs[i].b);
}

/// Follows an obstacle that moved: limit() has to measure its pairs again.
void Guard::follow_obstacle(uint32_t joint) {
  granted_[joint] = next_[joint];
  core_->roaming = 0;
  for (uint16_t i = 0; i < robot_->pair_count; ++i) {
    if (has_obstacle(i) && !is_released(pairs_[i].floor)) {
      pairs_[i].granted = kNotMeasured;
    }
  }
}

/// Discards all certificates with obstacles. The next period begins with them where they stand now.
void Guard::forget_obstacles() {
  uint32_t laps = 0;
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    if (robot_->joints[i].type == JointType::fixed) {
      before_[i] = granted_[i] = robot_->joints[i].offset;
      step_[i] = 0;
    }
    laps += robot_->joints[i].laps;
  }
  core_->laps = laps & detail::kLapMask;
  core_->roaming = 0;
  for (uint16_t i = 0; i < robot_->pair_count; ++i) {
    if (has_obstacle(i)) {
      pairs_[i] = kUnknown;
      core_->walked_pair = core_->walked_pair == i ? kNoPair : core_->walked_pair;
    }
  }
}

/// Calls `visit(joint, reach, way)` for each joint between two links. `way`: the larger travel from
/// the certificate to the period's begin or end. `first`: index of the pair's first joint in the
/// arrays of all pairs. Returns whether the certificate was measured where the period ends.
template <class Visit>
FLASHBVH_INLINE inline bool Guard::for_each_way(const RobotPair& pair, uint32_t first,
                                                Visit&& visit) const {
  const JointCoordinate* certified = certified_ + first;
  uint32_t moved = 0;
  detail::for_each_between(*robot_, pair, [&](uint32_t joint, uint32_t reach) {
    const int32_t way = detail::difference(before_[joint], *certified++);
    const int32_t began = is_free(joint) ? detail::wrapped(way) : way;
    const int32_t ended = detail::difference(began, -step_[joint]);
    visit(joint, reach, greater(detail::magnitude(began), detail::magnitude(ended)));
    moved |= static_cast<uint32_t>(ended);
  });
  return moved == 0;
}

/// Upper bound on how far two links moved towards each other since their certificate, by reaches.
uint32_t Guard::motion_of(const RobotPair& pair, uint32_t first, bool& is_fresh) const {
  detail::Travel since;
  is_fresh = for_each_way(
      pair, first, [&](uint32_t, uint32_t reach, uint32_t way) { since.add_short(reach, way); });
  return since.fine();
}

/// motion_of() by levers, which is no larger.
uint32_t Guard::motion_by_levers(const RobotPair& pair, uint32_t first) const {
  const uint8_t* share = shares_ + first;
  detail::LeverTravel since;
  (void)for_each_way(pair, first, [&](uint32_t joint, uint32_t reach, uint32_t way) {
    since.add(robot_->joints[joint], reach, *share++, way);
  });
  return since.fine();
}

Guard::Left Guard::left_of(uint16_t i, uint32_t first, bool by_levers) const {
  const RobotPair& pair = robot_->pairs[i];
  const GuardPair& known = pairs_[i];
  Left now;
  const uint32_t by_reaches = motion_of(pair, first, now.is_current);
  now.moved = by_levers ? motion_by_levers(pair, first) : by_reaches;
  const uint32_t began = (known.began & kOfNext) == 0 ? known.began : 0;
  const auto kept = [&](uint32_t measured) {
    return now.is_current ? detail::kept_of(measured, began, now.moved)
                          : difference_of(measured, now.moved);
  };
  now.distance = kept(known.lower);
  const uint32_t warn = pair.warn + robot_->slack;
  const uint32_t stop = pair.stop + robot_->slack;
  now.left = difference_of(now.distance, stop);
  // A joint that returns faster to a pose with a small certificate may need a larger one, if it can
  // be had. A pair measured where the period ends is settled: aim() in guard_measure.cpp.
  const uint32_t sought = now.left != 0 ? warn : stop;
  now.is_settled = now.is_current && !is_unknown(known) &&
                   (now.distance > warn || known.lower >= kMaxGuardDistance ||
                    kept(difference_of(known.upper, kRateMargin)) <= sought);
  if (now.left == 0) {
    look_inside(i, kept(difference_of(known.upper, kRateMargin)), now);
  }
  return now;
}

/// Upper bound on how far the joints move the pair in this period, in 1/256 cell.
uint32_t Guard::rate_of(const RobotPair& pair) const {
  detail::Travel rate;
  detail::for_each_between(*robot_, pair, [&](uint32_t joint, uint32_t reach) {
    rate.add_short(reach, detail::magnitude(step_[joint]));
  });
  return rate.fine();
}

/// The largest step of a joint in this period.
uint32_t Guard::longest_step() const {
  uint32_t longest = 0;
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    longest = greater(longest, detail::magnitude(step_[i]));
  }
  return longest;
}

/// The verdict of a pair that may be inside its warn distance.
Verdict Guard::verdict_of(uint16_t i, const Left& now) const {
  const RobotPair& pair = robot_->pairs[i];
  if (now.left != 0) {
    return now.distance > pair.stop + robot_->slack ? Verdict::warn : Verdict::leaving;
  }
  const bool is_near = sum_of(pairs_[i].upper, now.moved) <= lowest_of(i, now.is_current);
  return now.is_settled || is_near ? Verdict::stop : Verdict::not_yet_known;
}

Guard::Found Guard::look() {
  Found found = {Verdict::free, kNoPair, UINT32_MAX, kNoPair, 0, 1, 0, kNoPair, UINT32_MAX, 1};
  const uint32_t longest = longest_step();
  uint32_t first = 0;
  for (uint16_t i = 0; i < robot_->pair_count; ++i) {
    const RobotPair& pair = robot_->pairs[i];
    const uint32_t warn = pair.warn + robot_->slack;
    GuardPair& known = pairs_[i];
    Left now = left_of(i, first, false);
    if (is_near(difference_of(now.distance, warn), pair, longest)) {
      now = left_of(i, first, true);
    }
    const uint32_t until_warn = difference_of(now.distance, warn);
    if (!now.is_settled && is_near(until_warn, pair, longest)) {
      const uint32_t rate = rate_of(pair);
      const uint64_t soon = uint64_t{rate} * kPeriodsAhead;
      const bool is_due = now.left <= soon;
      const bool is_vague = until_warn <= soon && sum_of(known.upper, now.moved) > warn;
      if ((is_due || is_vague) && certify_by_table(i, rate)) {
        now = left_of(i, first, false);
      } else if (is_due) {
        found.take_due(i, now.left, sum_of(rate, 1));
      } else if (is_vague) {
        found.take_vague(i, until_warn, sum_of(rate, 1));
      }
    }
    first += pair.joints_a + pair.joints_b;
    if (now.distance == 0 && !now.is_current) {
      known.lower = 0;  // expired for good: the count of an obstacle's motion wraps at 32 bits
    }
    found.take(now.distance > warn ? Verdict::free : verdict_of(i, now), i,
               difference_of(now.distance, robot_->slack));
    found.walked_left = i == core_->walked_pair ? now.left : found.walked_left;
  }
  if (found.due == kNoPair) {
    found.due = found.vague;
    found.due_rate = found.vague_rate;
    found.due_left = UINT32_MAX;  // can wait
  }
  return found;
}

bool Guard::is_free(uint32_t joint) const {
  return robot_->joints[joint].type == JointType::continuous;
}

/// The step to the new coordinate from another one, by the shorter arc.
int32_t Guard::step_from(int32_t from, uint32_t joint) const {
  const int32_t step = detail::difference(next_[joint], from);
  return is_free(joint) ? detail::wrapped(step) : step;
}

int32_t Guard::step_to_next(uint32_t joint) const {
  return step_from(detail::difference(before_[joint], -step_[joint]), joint);
}

Status Guard::move_to(const JointCoordinate* values) {
  if (!fits()) {
    return refusal();
  }
  // Refused values must change nothing, so the new coordinates go to an array of their own.
  core_->has_frames = 0;
  const Status status = set_coordinates(*robot_, values, next_);
  if (status != Status::done) {
    return status;
  }
  const bool is_first = core_->has_values == 0;
  const auto step_of = [this](uint32_t joint) { return step_to_next(joint); };
  uint32_t laps = 0;
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    laps += robot_->joints[i].laps;
    if (!is_first && is_free(i) && !has_one_way(i, step_of)) {
      return Status::joint_jumped;
    }
  }
  if (!is_first && ((laps - core_->laps) & detail::kLapMask) >= detail::kTooManyLaps) {
    return Status::joint_jumped;
  }
  if (((laps ^ core_->laps) & detail::kLapMask) >> detail::kLapsOfWalkBits != 0) {
    core_->walked_pair = kNoPair;  // its certificate would count an obstacle's motion modulo 2^32
  }
  core_->laps = laps & detail::kLapMask;
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    const int32_t step = is_first ? 0 : step_to_next(i);
    before_[i] = detail::difference(next_[i], step);
    step_[i] = step;
    if (is_first) {
      granted_[i] = next_[i];
    } else if (robot_->joints[i].type == JointType::fixed && granted_[i] != next_[i]) {
      follow_obstacle(i);
    }
  }
  for (uint32_t i = 0; i < robot_->pair_count; ++i) {
    pairs_[i].began &= pairs_[i].began < kOfNext ? 0 : ~kOfNext;
  }
  core_->has_values = 1;
  return Status::done;
}

GuardAnswer Guard::update(const JointCoordinate* values, uint32_t work) {
  const Status status = move_to(values);
  return status == Status::done ? go_on(work)
                                : GuardAnswer{status, Verdict::refused, kNoPair, 0, 0};
}

/// Whether a walk of update() goes on.
bool Guard::is_walking() const {
  return core_->walked_pair != kNoPair && core_->kept == 0;
}

/// The loop terminates. Each iteration certifies a pair where the period ends, which settles it, so
/// no pair is due twice. One iteration may instead end a walk of an earlier period. A walk of
/// update() is abandoned only for a pair with nothing left, whose own walk is never abandoned;
/// limit()'s for any, and only limit() goes on with it.
GuardAnswer Guard::go_on(uint32_t work) {
  if (!has_values()) {
    return {refusal(), Verdict::refused, kNoPair, 0, 0};
  }
  const uint32_t granted = work;
  Found found = look();
  while (work != 0 && (found.due != kNoPair || is_walking())) {
    const Status status = measure(found, work);
    if (status == Status::suspended) {
      break;
    }
    if (status != Status::done) {
      return {status, Verdict::not_yet_known, found.pair, found.distance, granted - work};
    }
    found = look();
  }
  return {Status::done, found.verdict, found.pair, found.distance, granted - work};
}

}  // namespace flashbvh
