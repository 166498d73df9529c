// The guard: what each pair has to keep, by the distances that were measured so far.
//
// Source: lib/docs/derivations.md, "Floors".
#include "flashbvh/robot/guard.hpp"
#include "guard_parts.hpp"
#include "levers.hpp"

namespace flashbvh {

using detail::difference_of;
using detail::greater;
using detail::smaller;
using detail::sum_of;

namespace {

/// A pair may lose this part of its stop distance, or so many times what rounding may take.
constexpr uint32_t kGive = 10;
constexpr uint32_t kRoundings = 8;

}  // namespace

/// The part of Robot::slack that is not the links' deviation.
uint32_t Guard::rounding() const {
  return difference_of(robot_->slack, 2 * detail::largest_deviation(*robot_));
}

/// Looks at what is left of a pair inside its stop distance. `most`: the largest distance that
/// could be had.
void Guard::look_inside(uint16_t i, uint32_t most, Left& now) const {
  const uint32_t lowest = lowest_of(i, now.is_current);
  now.left = difference_of(now.distance, lowest);
  if (is_released(pairs_[i].floor)) {
    now.left = 1;
    now.is_settled = true;
  } else if (now.left == 0) {
    now.is_settled = now.is_settled && (pairs_[i].lower >= kMaxGuardDistance || most <= lowest);
  }
}

Guard::Give Guard::give_of(uint16_t i) const {
  const uint32_t rounding = core_->rounding;
  return {greater(robot_->pairs[i].stop / kGive, kRoundings * rounding), rounding};
}

/// The distance that a pair has to keep in update(): for the stop distance; or, if it has not been
/// a tenth beyond that since the start, for its floor. `is_current`: the certificate was measured
/// where the period ends, so that it raises only later floors.
uint32_t Guard::lowest_of(uint16_t i, bool is_current) const {
  const GuardPair& known = pairs_[i];
  const uint32_t limit = robot_->pairs[i].stop + robot_->slack;
  const bool is_own = !is_current && (known.seen & kOwn) != 0;
  const uint32_t seen = greater(known.seen & ~kOwn, is_own ? known.lower : 0);
  const Give give = give_of(i);
  const uint32_t floor = smaller(seen, limit + give.most);
  const uint32_t kept = greater(floor - give.of(floor), give.rounding);  // less may be contact
  return smaller(limit, kept + give.rounding);
}

Guard::Keep Guard::keep_of(uint16_t i) const {
  const uint32_t floor = pairs_[i].floor;
  const Give give = give_of(i);
  return {give.most, sum_of(robot_->pairs[i].stop + robot_->slack, give.most),
          sum_of(floor - give.of(floor), give.rounding), floor - give.of(floor) / 2};
}

/// Takes the distance at the granted values. A floor falls only if an obstacle came so near that
/// the robot could not move at all: to where the robot may stay and get no nearer.
void Guard::know(uint16_t i, uint32_t distance) {
  GuardPair& known = pairs_[i];
  const Keep keep = keep_of(i);
  const Give give = give_of(i);
  if (known.floor == kNoFloor) {
    known.floor = smaller(distance, keep.cap);
  } else {
    const uint32_t apart = sum_of(known.upper, 2 * give.rounding);
    known.floor = smaller(known.floor, sum_of(apart, smaller(give.most / 2, apart / 3)));
  }
  known.floor = greater(known.floor, smaller(distance, keep.cap));
  known.granted = distance;
}

bool Guard::knows_floors() const {
  bool knows = true;
  for (uint16_t i = 0; i < robot_->pair_count; ++i) {
    knows = knows && pairs_[i].granted != kNotMeasured;
  }
  return knows;
}

/// Measures the distances that are not known where the robot was sent last.
Status Guard::know_floors(uint32_t& work) {
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    next_[i] = granted_[i];
  }
  core_->has_frames = 0;
  for (uint16_t i = 0; i < robot_->pair_count; ++i) {
    GuardPair& known = pairs_[i];
    while (known.granted == kNotMeasured) {
      const uint32_t cap = keep_of(i).cap;
      const Bounds now = bounds_of(i, first_between(i));
      const bool is_tight = now.is_current && known.upper != UINT32_MAX &&
                            known.lower >= difference_of(known.upper, known.upper / 32 + 2);
      if (now.end >= cap || is_tight) {
        know(i, now.end);
        break;
      }
      const Status status = work == 0 ? Status::suspended : measure_at_next(i, cap, true, work);
      if (status != Status::done && (status != Status::suspended || work == 0)) {
        return status;
      }
    }
  }
  return Status::done;
}

Status Guard::release(uint16_t pair, FineLength a_command) {
  if (!has_values() || pair >= robot_->pair_count) {
    return refusal();
  }
  if (a_command.count > kMaxGuardDistance) {
    return Status::distance_out_of_range;
  }
  GuardPair& known = pairs_[pair];
  if (!is_released(known.floor)) {
    const Keep keep = keep_of(pair);
    const uint32_t now = known.granted == kNotMeasured ? 0 : known.granted;
    known.granted = smaller(sum_of(now, keep.most), keep.cap);
    known.seen = 0;
  }
  known.floor = kReleased + a_command.count;
  core_->roaming = 0;
  return Status::done;
}

}  // namespace flashbvh
