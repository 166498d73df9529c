// The guard: measuring pairs whose certificates are about to run out.
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
using detail::kPeriodsAhead;
using detail::kRateMargin;
using detail::sum_of;

namespace {

/// One by spheres is taken if it lasts so many times longer.
constexpr uint64_t kWorthwhile = 4;

static_assert(kMaxGuardDistance <= detail::Within::kMostShort, "WithinAlong tests short ones");

/// Spheres, and the pose of a pair that is going to be measured, in work (detail/walk/work.hpp).
constexpr uint32_t kPoseWork = 16;

/// The lever of a joint.
constexpr uint32_t kLeverWork = 1;

/// The distance of two triangles, and the next limit that follows from it.
constexpr uint32_t kAimWork = 56;

/// A witness's distance is computed again once the links have moved by one part in so many of its
/// excess over the distance to keep.
constexpr uint32_t kStaleShare = 8;

/// A pair is tested whether it is within a share of its witness's distance over the one to keep, in
/// 1/16: no triangles are tested for half of it, many for all.
constexpr uint32_t kShare = 9;

/// The same where a period moves it farther than that distance.
constexpr uint32_t kLastShare = 12;

/// And within what so many periods move it, if that is less; and at least within one part of so
/// many of the share, since joints speed up.
constexpr uint32_t kPeriodsAsked = 16;

}  // namespace

/// Its triangles in A's frame, in cells. False if B lies so far off that it was put nearer.
bool Guard::place_witness(uint16_t i, const Witness<uint16_t>& witness, const Pose& pose,
                          Triangle& a, Triangle& b) const {
  const Mesh& mesh_a = robot_->meshes[robot_->pairs[i].a];
  const Mesh& mesh_b = robot_->meshes[robot_->pairs[i].b];
  const detail::Transform transform(pose, mesh_a, mesh_b, /*may_stop=*/false);
  detail::place_pair(mesh_a, witness.a, mesh_b, witness.b, transform, a, b);
  return transform.is_near();
}

/// The number of the pair's first joint between, in the arrays of all pairs'.
uint32_t Guard::first_between(uint16_t i) const {
  uint32_t first = 0;
  for (uint16_t j = 0; j < i; ++j) {
    first += robot_->pairs[j].joints_a + robot_->pairs[j].joints_b;
  }
  return first;
}

/// What is known of the pair's distance where the period began.
uint32_t Guard::distance_where_begun(uint16_t i) const {
  const uint32_t first = first_between(i);
  const JointCoordinate* certified = certified_ + first;
  const uint8_t* share = shares_ + first;
  detail::LeverTravel since;
  detail::for_each_between(*robot_, robot_->pairs[i], [&](uint32_t joint, uint32_t reach) {
    const int32_t way = detail::difference(before_[joint], *certified++);
    since.add(robot_->joints[joint], reach, *share++,
              detail::magnitude(is_free(joint) ? detail::wrapped(way) : way));
  });
  const uint32_t by_certificate =
      difference_of(pairs_[i].lower, sum_of(since.fine(), robot_->slack));
  return detail::greater(by_certificate, pairs_[i].began);
}

/// `shares`: of the reaches, at those coordinates; null: all of them.
void Guard::certify(uint16_t i, const JointCoordinate* at, const GuardPair& certificate,
                    const uint8_t* shares) {
  const uint32_t began = distance_where_begun(i);
  const uint32_t first = first_between(i);
  JointCoordinate* to = certified_ + first;
  uint8_t* share = shares_ + first;
  core_->walked_pair = core_->walked_pair == i ? kNoPair : core_->walked_pair;
  pairs_[i] = certificate;
  pairs_[i].began = began;
  detail::for_each_between(*robot_, robot_->pairs[i], [&](uint32_t joint, uint32_t) {
    *to++ = at[joint];
    *share++ = shares == nullptr ? detail::kWholeReach : *shares++;
  });
}

/// How far the joints move it in this period.
uint32_t Guard::moved_in_walk() const {
  const uint8_t* share = walked_shares_;
  detail::LeverTravel moved;
  detail::for_each_between(
      *robot_, robot_->pairs[core_->walked_pair], [&](uint32_t joint, uint32_t reach) {
        moved.add(robot_->joints[joint], reach, *share++, detail::magnitude(step_[joint]));
      });
  return moved.fine();
}

/// To where the period ends: values that were refused may stand there.
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

bool Guard::certify_by_spheres(uint16_t i, uint32_t rate) {
  const RobotPair& pair = robot_->pairs[i];
  const RobotLink& a = robot_->links[pair.a];
  const RobotLink& b = robot_->links[pair.b];
  const uint32_t apart = detail::sphere_gap(a, detail::frame_of(frames_, a.joint), b,
                                            detail::frame_of(frames_, b.joint));
  const uint32_t known = difference_of(apart, robot_->slack);
  const uint32_t left = difference_of(known, pair.stop);
  const uint32_t worth = (a.radius >> 7) + (b.radius >> 7);  // a sixteenth of the radii, 1/256 cell
  const bool is_worthwhile = difference_of(known, rate) > pair.warn && left >= worth &&
                             left > uint64_t{rate} * (kPeriodsAhead * kWorthwhile);
  if (!is_worthwhile && apart < kMaxGuardDistance) {  // farther, triangles show no more
    return false;
  }
  certify(i, next_, {apart, UINT32_MAX, 0, pairs_[i].witness}, nullptr);
  return true;
}

/// By what is known of where the joints stand, if that lasts: no pose, and no triangles.
bool Guard::certify_by_table(uint16_t i, uint32_t rate) {
  set_next();
  const RobotPair& pair = robot_->pairs[i];
  const uint32_t tabulated = detail::table_distance_at(*robot_, i, next_);
  const uint32_t known = difference_of(tabulated, robot_->slack);
  if (difference_of(known, rate) <= pair.warn ||
      known - pair.stop <= uint64_t{rate} * (kPeriodsAhead + 1)) {
    return false;
  }
  certify(i, next_, {tabulated, UINT32_MAX, 0, pairs_[i].witness}, nullptr);
  return true;
}

void Guard::begin_walk(uint16_t i, uint32_t& work) {
  const uint32_t since = motion_by_levers(robot_->pairs[i], first_between(i));
  core_->walked_pair = i;
  detail::set_shares(*robot_, robot_->pairs[i], frames_, walked_shares_);
  detail::take_work(work, (robot_->pairs[i].joints_a + robot_->pairs[i].joints_b) * kLeverWork);
  core_->pose = pose_of(robot_->pairs[i]);
  core_->witness = pairs_[i].witness;
  for (uint32_t joint = 0; joint < robot_->joint_count; ++joint) {
    walked_[joint] = next_[joint];
  }
  const uint32_t upper = pairs_[i].upper;
  const bool is_stale = since > difference_of(upper, limit_for(i, upper)) / kStaleShare;
  aim(upper == UINT32_MAX || is_stale ? witness_distance(work) : sum_of(upper, since));
}

/// Which limit a pair that is so near is to be kept beyond, with the slack.
uint32_t Guard::limit_for(uint16_t i, uint32_t nearest) const {
  const uint32_t warn = sum_of(robot_->pairs[i].warn, robot_->slack);
  return nearest > warn ? warn : sum_of(robot_->pairs[i].stop, robot_->slack);
}

/// How far apart the witness is, where the pair is being measured; UINT32_MAX: not known.
uint32_t Guard::witness_distance(uint32_t& work) const {
  Triangle a;
  Triangle b;
  const bool is_placed = place_witness(core_->walked_pair, core_->witness, core_->pose, a, b);
  detail::take_work(work, kAimWork);
  return is_placed ? detail::distance_above(a, b) : UINT32_MAX;
}

/// The distance to test: a share of the witness's distance over the one to keep. `nearest`: it
/// is no farther. Less than `nearest`, so each witness that is found is nearer than the last. A
/// "no" settles the pair (Left::is_settled): the limit is as far as can be, or beyond what
/// lasts the period and the warn distance, or the stop distance; else the witness is no farther
/// than that.
void Guard::aim(uint32_t nearest) {
  const RobotPair& pair = robot_->pairs[core_->walked_pair];
  const uint32_t kept = limit_for(core_->walked_pair, nearest);
  const uint32_t over = difference_of(nearest, kept);
  const uint32_t most = over / 16 * kShare;
  // As far as so many periods like this one move the links: farther takes walks of many periods.
  const uint32_t moved = sum_of(moved_in_walk(), kRateMargin);
  const uint32_t least = most / kPeriodsAsked;
  const uint32_t share = moved >= over    ? difference_of(over, uint32_t{1}) / 16 * kLastShare
                         : moved >= least ? most
                                          : detail::greater(moved * kPeriodsAsked, least);
  const uint32_t began = distance_where_begun(core_->walked_pair);
  const uint32_t for_stop = detail::lasting(pair.stop, began, moved, robot_->slack);
  const uint32_t for_warn = detail::lasting(pair.warn, began, moved, robot_->slack);
  const uint32_t lasting = nearest > for_warn ? for_warn : nearest > for_stop ? for_stop : 0;
  const uint32_t asked = detail::greater(sum_of(kept, share), lasting);
  core_->nearest = nearest;
  core_->asked = asked < kMaxGuardDistance ? asked : kMaxGuardDistance;
  core_->cursor = {};
}

/// One run of the question. `done`: the pair has its certificate; `full`: the witness is nearer
/// than the limit.
Status Guard::walk(uint32_t& work) {
  const RobotPair& pair = robot_->pairs[core_->walked_pair];
  if (core_->nearest <= sum_of(pair.stop, robot_->slack)) {
    return finish({0, core_->nearest, 0, core_->witness});
  }
  Query<Ranked<Mesh>, detail::WithinAlong> query(robot_->meshes[pair.a], robot_->meshes[pair.b],
                                                 core_->pose, {},
                                                 detail::WithinAlong(within(core_->asked)));
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
    return finish({core_->asked, core_->nearest, 0, core_->witness});
  }
  if (status == Status::distance_out_of_range && core_->asked > 1) {
    core_->asked /= 2;
    core_->nearest = core_->asked;  // too near is reported at worst, and not tested again
    detail::take_work(work, kPoseWork);
    return Status::suspended;
  }
  if (status == Status::cursor_invalid) {  // of a state that was taken up
    core_->cursor = {};
    return Status::suspended;
  }
  return status;
}

Status Guard::finish(const GuardPair& certificate) {
  certify(core_->walked_pair, walked_, certificate, walked_shares_);
  return Status::done;
}

/// Goes on with what is being measured, unless another pair can't wait for it. With unlimited work
/// it ends: each turn of the loop ends the walk, takes a nearer witness, halves the limit, or
/// begins a walk of a damaged state again, once.
Status Guard::measure(const Found& found, uint32_t& work) {
  const bool is_overtaken = found.due != core_->walked_pair && found.due != kNoPair &&
                            found.due_left == 0 && found.walked_left != 0;
  if (core_->walked_pair == kNoPair || is_overtaken) {
    detail::take_work(work, kPoseWork);
    make_frames();
    if (certify_by_spheres(found.due, found.due_rate)) {
      return Status::done;
    }
    begin_walk(found.due, work);
  }
  if (core_->pose.status() == Status::suspended || core_->pose.status() == Status::full) {
    return Status::guard_state_invalid;  // damaged: no pose ends so, and a walk by it would not end
  }
  Status status = Status::suspended;
  while (status == Status::suspended && work != 0) {
    status = walk(work);
    if (status ==
        Status::full) {  // apart from the walk, so that their stacks are never needed at once
      const uint32_t above = witness_distance(work);
      aim(above < core_->asked ? above : core_->asked);
      status = Status::suspended;
    }
  }
  return status;
}

}  // namespace flashbvh
