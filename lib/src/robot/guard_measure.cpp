// The guard: measures pairs whose certificates are about to expire.
#include "branch.hpp"
#include "coordinate.hpp"
#include "flashbvh/detail/query/within_along.hpp"
#include "flashbvh/detail/robot/distance_table.hpp"
#include "flashbvh/robot/guard.hpp"
#include "guard_parts.hpp"
#include "levers.hpp"
#include "spheres.hpp"

namespace flashbvh {

using detail::difference_of;
using detail::greater;
using detail::kAimWork;
using detail::kLeverWork;
using detail::kPeriodsAhead;
using detail::kPoseWork;
using detail::kRateMargin;
using detail::smaller;
using detail::sum_of;

namespace {

/// A certificate by spheres is used only if it lasts this many times longer.
constexpr uint64_t kWorthwhile = 4;

static_assert(kMaxGuardDistance <= detail::Within::kMostShort, "WithinAlong tests short ones");

/// A witness's distance is computed again once the links have moved by 1/kStaleShare of its excess
/// over the distance to keep.
constexpr uint32_t kStaleShare = 8;

/// Share of a witness's excess over the distance to keep that is added to the tested distance, in
/// 1/16. Half of the excess needs no triangle tests, all of it needs many.
constexpr uint32_t kShare = 9;

/// The share if a period moves the pair by more than the excess, in 1/16.
constexpr uint32_t kLastShare = 12;

/// The share is limited to the motion of this number of periods, but not below 1/kMaxPeriods of
/// itself, since joints speed up.
constexpr uint32_t kMaxPeriods = 16;

}  // namespace

/// Sets the witness's triangles in A's frame, in cells. False if B is out of range, where it is
/// placed nearer.
bool Guard::place_witness(uint16_t i, const Witness<uint16_t>& witness, const Pose& pose,
                          Triangle& a, Triangle& b) const {
  const Mesh& mesh_a = robot_->meshes[robot_->pairs[i].a];
  const Mesh& mesh_b = robot_->meshes[robot_->pairs[i].b];
  const detail::Transform transform(pose, mesh_a, mesh_b, /*may_stop=*/false);
  detail::place_pair(mesh_a, witness.a, mesh_b, witness.b, transform, a, b);
  return transform.is_near();
}

/// Index of the pair's first joint in the arrays of all pairs' joints between.
uint32_t Guard::first_between(uint16_t i) const {
  uint32_t first = 0;
  for (uint16_t j = 0; j < i; ++j) {
    first += robot_->pairs[j].joints_a + robot_->pairs[j].joints_b;
  }
  return first;
}

/// Lower bound on the pair's distance at the period's begin, in 1/256 cell; or, with kOfNext, at
/// its end, where the next one begins.
uint32_t Guard::distance_where_begun(uint16_t i, uint32_t of_next) const {
  const uint32_t first = first_between(i);
  const JointCoordinate* certified = certified_ + first;
  const uint8_t* share = shares_ + first;
  detail::LeverTravel since;
  detail::for_each_between(*robot_, robot_->pairs[i], [&](uint32_t joint, uint32_t reach) {
    const int32_t end = detail::difference(0, step_[joint]);
    const int32_t began = detail::difference(before_[joint], of_next != 0 ? end : 0);
    const int32_t way = detail::difference(began, *certified++);
    since.add(robot_->joints[joint], reach, *share++,
              detail::magnitude(is_free(joint) ? detail::wrapped(way) : way));
  });
  const uint32_t began = pairs_[i].began;
  const uint32_t known = (began & kOfNext) == of_next ? began & ~kOfNext : 0;
  return greater(difference_of(pairs_[i].lower, since.fine()), known);
}

/// Stores a certificate, and what its last one says of the largest distance since the start. `at`:
/// the coordinates at which it was measured. `is_own`: update() measured it, so the robot was
/// there. `shares`: of the reaches there; null: whole reaches.
void Guard::certify(uint16_t i, const JointCoordinate* at, const Measured& measured, bool is_own,
                    const uint8_t* shares) {
  const uint32_t of_next = is_own ? 0 : kOfNext;
  const uint32_t began = smaller(distance_where_begun(i, of_next), kMaxGuardDistance) | of_next;
  const uint32_t first = first_between(i);
  JointCoordinate* to = certified_ + first;
  uint8_t* share = shares_ + first;
  core_->walked_pair = core_->walked_pair == i ? kNoPair : core_->walked_pair;
  GuardPair& known = pairs_[i];
  const uint32_t last = (known.seen & kOwn) != 0 ? smaller(known.lower, kMaxGuardDistance) : 0;
  known.seen = greater(known.seen & ~kOwn, last) | (is_own ? kOwn : 0);
  known.lower = measured.lower;
  known.upper = measured.upper;
  known.began = began;
  known.witness = measured.witness;
  detail::for_each_between(*robot_, robot_->pairs[i], [&](uint32_t joint, uint32_t) {
    *to++ = at[joint];
    *share++ = shares == nullptr ? detail::kWholeReach : *shares++;
  });
}

/// Upper bound on the measured pair's motion in this period, in 1/256 cell.
uint32_t Guard::moved_in_walk() const {
  const uint8_t* share = walked_shares_;
  detail::LeverTravel moved;
  detail::for_each_between(
      *robot_, robot_->pairs[core_->walked_pair], [&](uint32_t joint, uint32_t reach) {
        moved.add(robot_->joints[joint], reach, *share++, detail::magnitude(step_[joint]));
      });
  return moved.fine();
}

/// Sets `next` to the end of the period, as it may hold values that were refused.
void Guard::set_next() {
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    next_[i] = detail::difference(before_[i], -step_[i]);
  }
}

void Guard::make_frames() {
  if (core_->has_frames != 0) {
    return;
  }
  set_next();
  set_frames(*robot_, next_, frames_);
  core_->has_frames = 1;
}

Pose Guard::pose_of(const RobotPair& pair) const {
  return relative_pose(detail::frame_of(frames_, robot_->links[pair.a].joint),
                       detail::frame_of(frames_, robot_->links[pair.b].joint));
}

/// Returns whether a pair at a distance stays beyond its warn distance in a period of motion
/// `rate`.
bool Guard::is_free_after(const RobotPair& pair, uint32_t distance, uint32_t rate) const {
  return difference_of(distance, rate) > pair.warn + robot_->slack;
}

bool Guard::certify_by_spheres(uint16_t i, uint32_t rate) {
  const RobotPair& pair = robot_->pairs[i];
  const RobotLink& a = robot_->links[pair.a];
  const RobotLink& b = robot_->links[pair.b];
  const uint32_t apart = detail::sphere_gap(a, detail::frame_of(frames_, a.joint), b,
                                            detail::frame_of(frames_, b.joint));
  const uint32_t left = difference_of(apart, pair.stop + robot_->slack);
  const uint32_t worth = (a.radius >> 7) + (b.radius >> 7);  // a sixteenth of the radii, 1/256 cell
  const bool is_worthwhile = is_free_after(pair, apart, rate) && left >= worth &&
                             left > uint64_t{rate} * (kPeriodsAhead * kWorthwhile);
  if (!is_worthwhile && apart < kMaxGuardDistance) {  // beyond it triangles prove no more
    return false;
  }
  certify(i, next_, {apart, UINT32_MAX, pairs_[i].witness}, true, nullptr);
  return true;
}

/// Certifies by the distance table, if that lasts; needs no pose and no triangles.
bool Guard::certify_by_table(uint16_t i, uint32_t rate) {
  set_next();
  const RobotPair& pair = robot_->pairs[i];
  const uint32_t tabulated = detail::table_distance_at(*robot_, i, next_);
  if (!is_free_after(pair, tabulated, rate) ||
      tabulated - pair.stop - robot_->slack <= uint64_t{rate} * (kPeriodsAhead + 1)) {
    return false;
  }
  certify(i, next_, {tabulated, UINT32_MAX, pairs_[i].witness}, true, nullptr);
  return true;
}

/// Makes the pair, at `next_`, the measured one.
void Guard::start_walk(uint16_t i, uint32_t& work) {
  core_->walked_pair = i;
  core_->kept = 0;
  detail::set_shares(*robot_, robot_->pairs[i], frames_, walked_shares_);
  detail::take_work(work, (robot_->pairs[i].joints_a + robot_->pairs[i].joints_b) * kLeverWork);
  core_->pose = pose_of(robot_->pairs[i]);
  core_->witness = pairs_[i].witness;
  for (uint32_t joint = 0; joint < robot_->joint_count; ++joint) {
    walked_[joint] = next_[joint];
  }
}

void Guard::begin_walk(uint16_t i, uint32_t& work) {
  const uint32_t since = motion_by_levers(robot_->pairs[i], first_between(i));
  start_walk(i, work);
  const uint32_t upper = pairs_[i].upper;
  const bool is_stale = since > difference_of(upper, limit_for(i, upper)) / kStaleShare;
  aim(upper == UINT32_MAX || is_stale ? witness_distance(work) : sum_of(upper, since));
}

/// The distance to keep for a pair at distance `nearest`: for warn, stop, or its floor.
uint32_t Guard::limit_for(uint16_t i, uint32_t nearest) const {
  const uint32_t warn = robot_->pairs[i].warn + robot_->slack;
  const uint32_t stop = robot_->pairs[i].stop + robot_->slack;
  return nearest > warn ? warn : nearest > stop ? stop : lowest_of(i, true);
}

/// Distance of the witness at the measured pair's pose, in 1/256 cell; UINT32_MAX if not known.
uint32_t Guard::witness_distance(uint32_t& work) const {
  Triangle a;
  Triangle b;
  const bool is_placed = place_witness(core_->walked_pair, core_->witness, core_->pose, a, b);
  detail::take_work(work, kAimWork);
  return is_placed ? detail::distance_above(a, b) : UINT32_MAX;
}

/// Chooses the distance to test: the distance to keep and a share of the witness's excess over it.
/// `nearest`: upper bound on the witness's distance. The result is below it, so each witness found
/// is nearer than the last one. A "no" settles the pair (Left::is_settled), as one of these holds.
/// The limit is the largest one; or it lasts for the period beyond the warn or stop distance; or
/// the witness is no farther than such a limit.
void Guard::aim(uint32_t nearest) {
  if (core_->kept != 0) {
    aim_to_know(nearest);
    return;
  }
  const uint16_t i = core_->walked_pair;
  const uint32_t stop = robot_->pairs[i].stop + robot_->slack;
  const uint32_t warn = robot_->pairs[i].warn + robot_->slack;
  const uint32_t kept = limit_for(i, nearest);
  const uint32_t over = difference_of(nearest, kept);
  const uint32_t most = over / 16 * kShare;
  // Limited to the motion of kMaxPeriods periods, as larger distances take walks of many periods.
  const uint32_t moved = sum_of(moved_in_walk(), kRateMargin);
  const uint32_t least = most / kMaxPeriods;
  const uint32_t share = nearest <= stop  ? over - (smaller(over, give_of(i).most) + 3) / 4
                         : moved >= over  ? difference_of(over, uint32_t{1}) / 16 * kLastShare
                         : moved >= least ? most
                                          : greater(moved * kMaxPeriods, least);
  const uint32_t began = distance_where_begun(i, 0);
  const uint32_t for_warn = detail::lasting(warn, began, moved);
  const uint32_t for_stop = detail::lasting(stop, began, moved);
  const uint32_t for_floor = detail::lasting(lowest_of(i, true), began, moved);
  const uint32_t lasting = nearest > for_warn    ? for_warn
                           : nearest > for_stop  ? for_stop
                           : nearest > for_floor ? for_floor
                                                 : 0;
  const uint32_t limit = greater(sum_of(kept, share), lasting);
  core_->nearest = nearest;
  core_->asked = limit < kMaxGuardDistance ? limit : kMaxGuardDistance;
  core_->cursor = {};
}

/// Chooses the distance to test for limit(): the one that it wants to know of and most of the
/// witness's excess over it; of a witness that is nearer, almost its own.
void Guard::aim_to_know(uint32_t nearest) {
  const uint32_t over = difference_of(nearest, core_->kept);
  const uint32_t asked =
      over != 0 ? core_->kept + over / 4 * 3 : difference_of(nearest, nearest / 64 + 1);
  core_->nearest = nearest;
  core_->asked = asked < kMaxGuardDistance ? asked : kMaxGuardDistance;
  core_->cursor = {};
}

/// Runs a slice of the measured pair's query. `done`: the pair has its certificate; `full`: the
/// witness is nearer than the limit.
Status Guard::walk(uint32_t& work) {
  const RobotPair& pair = robot_->pairs[core_->walked_pair];
  const bool is_settled =
      core_->kept == 0 ? core_->nearest <= limit_for(core_->walked_pair, 0) : core_->asked == 0;
  if (is_settled) {
    return finish(0);
  }
  Query<Ranked<Mesh>, detail::WithinAlong> query(robot_->meshes[pair.a], robot_->meshes[pair.b],
                                                 core_->pose, {},
                                                 detail::WithinAlong(within({core_->asked})));
  Status status = query.resume(core_->cursor);
  if (status == Status::suspended) {
    const uint32_t granted = work;
    const RunResult step = query.run(granted, [](const TrianglePair<uint16_t>&) { return false; });
    status = step.status;
    work = granted - step.work;
    core_->cursor = query.cursor();
    if (status == Status::full) {
      const TrianglePair<uint16_t> nearer = query.last_slots();
      core_->witness = {nearer.a, nearer.b};
    }
  }
  if (status == Status::done) {
    return finish(core_->asked);
  }
  if (status == Status::distance_out_of_range && core_->asked > 1) {
    core_->asked /= 2;
    core_->nearest = core_->asked;  // at worst too small a distance is reported; not tested again
    detail::take_work(work, kPoseWork);
    return Status::suspended;
  }
  if (status == Status::cursor_invalid) {  // of a state that was resumed
    core_->cursor = {};
    return Status::suspended;
  }
  return status;
}

/// Ends the measurement: the pair is at least `lower` apart.
Status Guard::finish(uint32_t lower) {
  certify(core_->walked_pair, walked_, {lower, core_->nearest, core_->witness}, core_->kept == 0,
          walked_shares_);
  return Status::done;
}

/// Continues the current measurement, unless another pair is more urgent. Terminates with unlimited
/// work: each iteration ends the walk, takes a nearer witness, halves the limit, or restarts a walk
/// of a damaged state, once.
Status Guard::measure(const Found& found, uint32_t& work) {
  const bool is_overtaken = found.due != core_->walked_pair && found.due != kNoPair &&
                            found.due_left == 0 && found.walked_left != 0;
  if (!is_walking() || is_overtaken) {
    detail::take_work(work, kPoseWork);
    make_frames();
    if (certify_by_spheres(found.due, found.due_rate)) {
      return Status::done;
    }
    begin_walk(found.due, work);
  }
  return walk_on(0, work);
}

/// Continues the measurement. `full`: a witness is nearer than `needed`.
Status Guard::walk_on(uint32_t needed, uint32_t& work) {
  if (core_->pose.status() == Status::suspended || core_->pose.status() == Status::full) {
    return Status::guard_state_invalid;  // damaged: no pose has such a status; a walk would not end
  }
  Status status = Status::suspended;
  while (status == Status::suspended && work != 0) {
    status = walk(work);
    if (status == Status::full) {  // outside the walk, so that their stack frames do not add up
      const uint32_t above = witness_distance(work);
      aim(above < core_->asked ? above : core_->asked);
      status = core_->nearest < needed ? Status::full : Status::suspended;
    }
  }
  return status;
}

/// Whether limit() measures the pair at the next coordinates already.
bool Guard::is_walked_at_next(uint16_t i) const {
  bool is = core_->walked_pair == i && core_->kept != 0;
  for (uint32_t joint = 0; joint < robot_->joint_count; ++joint) {
    is = is && walked_[joint] == next_[joint];
  }
  return is;
}

/// Measures a pair at the next coordinates. `done`: it is farther apart than `needed`, or, for a
/// floor, its certificate says almost what its distance is; `full`: a witness is nearer;
/// `suspended`, with work left: an earlier measurement ended, of this pair or another one.
Status Guard::measure_at_next(uint16_t i, uint32_t needed, bool is_for_floor, uint32_t& work) {
  const uint32_t least = is_for_floor ? 0 : needed + 1;  // a witness there proves less
  Status status = Status::suspended;
  if (is_walked_at_next(i)) {
    status = walk_on(least, work);
  } else if (core_->walked_pair != kNoPair) {
    status = walk_on(0, work);
    return status == Status::done ? Status::suspended : status;
  } else {
    detail::take_work(work, kPoseWork);
    if (core_->has_frames == 0) {
      set_frames(*robot_, next_, frames_);
      core_->has_frames = 1;
    }
    const RobotLink& a = robot_->links[robot_->pairs[i].a];
    const RobotLink& b = robot_->links[robot_->pairs[i].b];
    const uint32_t apart = detail::sphere_gap(a, detail::frame_of(frames_, a.joint), b,
                                              detail::frame_of(frames_, b.joint));
    if (apart / 2 > needed) {  // it lasts
      certify(i, next_, {apart, UINT32_MAX, pairs_[i].witness}, false, nullptr);
      return Status::done;
    }
    start_walk(i, work);
    const uint32_t nearest = witness_distance(work);
    const bool is_nearer = nearest <= needed;
    core_->kept = is_nearer ? greater(difference_of(nearest, nearest / 64 + 1), 1) : needed;
    aim(nearest);
    status = is_nearer && !is_for_floor ? Status::full : walk_on(least, work);
  }
  if (status == Status::full) {
    pairs_[i].witness = core_->witness;
    core_->walked_pair = kNoPair;
  }
  return status;
}

}  // namespace flashbvh
