// The guard: lets a command through as far as no pair comes nearer than its floor allows.
//
// Source: lib/docs/derivations.md, "Floors".
#include "branch.hpp"
#include "coordinate.hpp"
#include "flashbvh/robot/guard.hpp"
#include "guard_parts.hpp"
#include "levers.hpp"

namespace flashbvh {

using detail::difference_of;
using detail::greater;
using detail::smaller;

namespace {

/// The whole way; shares are in 1/4,096.
constexpr uint32_t kWhole = 1u << 12;
/// Shares that one command tries before it grants nothing.
constexpr int kMostTries = 8;
/// From this try on, shares fall by this.
constexpr int kManyTries = 3;
constexpr uint32_t kFaster = 8;
/// The part of the share by the closed form that is tried, in 1/16.
constexpr uint32_t kSafe = 15;

/// `of` times up / down, at most `of`.
constexpr uint32_t part_of(uint32_t of, uint64_t up, uint64_t down) {
  return up >= down ? of : static_cast<uint32_t>(of * up / down);
}

}  // namespace

/// The result of trying a share.
struct Guard::Try {
  Status status;  ///< `done`: all keep what they have to; `full`: `pair` does not; `suspended`:
                  ///< there was no work to know it; or a query's error
  uint16_t pair;
  uint64_t up;  ///< up / down: the part of this share to try next
  uint64_t down;
};

/// Checks the wanted values.
Status Guard::begin_command(const JointCoordinate* wanted) {
  if (!has_values()) {
    return refusal();
  }
  core_->has_frames = 0;
  const Status status = set_coordinates(*robot_, wanted, next_);
  if (status != Status::done) {
    return status;
  }
  const auto step_of = [this](uint32_t joint) { return step_from(granted_[joint], joint); };
  uint32_t laps = 0;
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    if (is_free(i) && !has_one_way(i, step_of)) {
      return Status::joint_jumped;
    }
    laps += robot_->joints[i].laps;
  }
  if (((laps - core_->laps) & detail::kLapMask) >= detail::kTooManyLaps) {
    return Status::joint_jumped;
  }
  return Status::done;
}

/// Sets values at a share of the way, cut towards the granted ones.
void Guard::set_share(const JointCoordinate* wanted, uint32_t share, JointCoordinate* granted) {
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    const RobotJoint& joint = robot_->joints[i];
    if (joint.shift != 0) {  // a mimic's, or an obstacle's
      continue;
    }
    const JointCoordinate from = granted_[i];
    const int32_t way = detail::difference(wanted[joint.variable], from);
    const int64_t part = int64_t{is_free(i) ? detail::wrapped(way) : way} * share / kWhole;
    granted[joint.variable] =
        share == kWhole ? wanted[joint.variable] : from + static_cast<JointCoordinate>(part);
  }
}

/// How far each joint may go beyond this motion, in units of its coordinate, before the pair's
/// certificate says less than `cap`; 0 if it says less within it.
uint32_t Guard::room_of(uint16_t i, uint32_t first, uint32_t cap) const {
  const RobotPair& pair = robot_->pairs[i];
  const JointCoordinate* certified = certified_ + first;
  detail::Travel since;
  detail::for_each_between(*robot_, pair, [&](uint32_t joint, uint32_t reach) {
    const int32_t way = detail::difference(granted_[joint], *certified++);
    const int32_t began = is_free(joint) ? detail::wrapped(way) : way;
    const int32_t ended = detail::difference(began, -step_from(granted_[joint], joint));
    since.add_short(reach, greater(detail::magnitude(began), detail::magnitude(ended)));
  });
  const uint32_t left = difference_of(difference_of(pairs_[i].lower, since.fine()), cap);
  return smaller(left, 0xFFFFFF) * 256 / ((pair.reach >> (kReachBits - 8)) + 1);
}

Guard::Bounds Guard::bounds_of(uint16_t i, uint32_t first) const {
  const JointCoordinate* certified = certified_ + first;
  const uint8_t* shares = shares_ + first;
  detail::LeverTravel to_any;
  detail::LeverTravel to_end;
  detail::LeverTravel motion;
  detail::Travel since;
  uint32_t moved = 0;
  detail::for_each_between(*robot_, robot_->pairs[i], [&](uint32_t number, uint32_t reach) {
    const RobotJoint& joint = robot_->joints[number];
    const int32_t way = detail::difference(granted_[number], *certified++);
    const int32_t began = is_free(number) ? detail::wrapped(way) : way;
    const int32_t step = step_from(granted_[number], number);
    const uint32_t ended = detail::magnitude(detail::difference(began, -step));
    const uint32_t most = greater(detail::magnitude(began), ended);
    to_any.add(joint, reach, *shares, most);
    to_end.add(joint, reach, *shares, ended);
    motion.add(joint, reach, *shares, detail::magnitude(step));
    since.add_short(reach, most);
    moved |= ended;
    ++shares;
  });
  const uint32_t lower = pairs_[i].lower;
  return {difference_of(lower, to_any.fine()), difference_of(lower, to_end.fine()),
          motion.fine(since.fine()), moved == 0};
}

/// Measures of released pairs whether their floors hold again at the next coordinates.
void Guard::measure_released(uint32_t& work) {
  uint32_t first = 0;
  for (uint16_t i = 0; i < robot_->pair_count; ++i) {
    const GuardPair& known = pairs_[i];
    if (work != 0 && is_released(known.floor) && bounds_of(i, first).end < known.granted) {
      (void)measure_at_next(i, known.granted, false, work);
    }
    first += robot_->pairs[i].joints_a + robot_->pairs[i].joints_b;
  }
}

/// Whether the last command from the granted to the next coordinates had too little work.
bool Guard::is_tried() const {
  bool is = true;
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    is = is && tried_[i] == next_[i];
  }
  return is;
}

/// Tries the next coordinates for one pair by its certificate. `suspended`: that says too little,
/// and a distance of `needed` at the end would do.
Guard::Try Guard::try_known(uint16_t i, uint32_t first, const Keep& keep, uint32_t& needed) const {
  const Bounds now = bounds_of(i, first);
  if (is_released(pairs_[i].floor)) {
    const uint32_t allowed = pairs_[i].floor - kReleased;
    return {now.motion > allowed ? Status::full : Status::done, i, allowed, now.motion};
  }
  const uint32_t begin = pairs_[i].granted;
  const uint32_t by_begin = difference_of(begin, now.motion);
  const uint64_t both = uint64_t{keep.along} * 2 + now.motion;
  const bool keeps_along =
      greater(now.along, by_begin) >= keep.along || uint64_t{begin} + now.end >= both;
  const bool keeps = keeps_along && greater(now.end, by_begin) >= keep.end;
  const uint64_t by_both = by_begin >= keep.along ? 0 : difference_of(both, uint64_t{begin});
  needed = greater(keep.end, static_cast<uint32_t>(by_both));
  return {keeps ? Status::done : Status::suspended, i,
          difference_of(begin, greater(keep.along, keep.end)), now.motion};
}

/// Tries the next coordinates for one pair, and measures it if its certificate says too little.
Guard::Try Guard::try_pair(uint16_t i, uint32_t& work) {
  const uint32_t first = first_between(i);
  const Keep keep = keep_of(i);
  for (bool is_measured = false;;) {
    uint32_t needed = 0;
    const Try known = try_known(i, first, keep, needed);
    if (known.status != Status::suspended || work == 0) {
      return known;
    }
    const Status status = is_measured ? Status::full : measure_at_next(i, needed, false, work);
    is_measured = is_measured || status == Status::done;
    if (status == Status::full) {  // the witness's distance changes evenly, as far as one knows
      const uint32_t begin = pairs_[i].granted;
      const uint32_t loss = difference_of(begin, core_->nearest);
      const uint64_t end_up = difference_of(begin, keep.end);
      const uint64_t along_up = difference_of(begin, keep.along);
      const uint64_t along_down = (known.down + loss) / 2 + 1;
      const bool is_end = end_up * along_down < along_up * loss;
      return {status, i, is_end ? end_up : along_up, is_end ? loss : along_down};
    }
    if (status != Status::done && status != Status::suspended) {
      return {status, i, known.up, known.down};
    }
  }
}

/// Tries the next coordinates for all pairs by what is known of them. The result is the pair that
/// allows the least share.
Guard::Try Guard::try_all_known() {
  uint32_t needed = 0;
  uint32_t first = 0;
  Try least = {Status::done, kNoPair, 1, 1};
  core_->roaming = UINT32_MAX;
  for (uint16_t i = 0; i < robot_->pair_count; ++i) {
    const Keep keep = keep_of(i);
    const uint32_t room = pairs_[i].floor == keep.cap ? room_of(i, first, keep.cap) : 0;
    core_->roaming = smaller(core_->roaming, room);
    if (room != 0) {
      pairs_[i].granted = keep.cap;  // at both ends and between
    } else {
      const Try tried = try_known(i, first, keep, needed);
      const bool is_less = tried.up * least.down < least.up * tried.down;  // 0 / 0 is not
      if (tried.status != Status::done && (is_less || least.status == Status::done)) {
        least = tried;
      }
    }
    first += robot_->pairs[i].joints_a + robot_->pairs[i].joints_b;
  }
  return least;
}

/// Tries the next coordinates for all pairs. Work goes to the pair that allows the least share
/// without it: another one may need more than one command's, over and over.
Guard::Try Guard::try_all(uint32_t& work) {
  for (;;) {
    Try least = try_all_known();
    if (least.status == Status::suspended && work != 0) {
      least = try_pair(least.pair, work);
      if (least.status == Status::done) {
        continue;
      }
    }
    if (least.status == Status::done) {
      measure_released(work);
    } else {
      core_->roaming = 0;
    }
    return least;
  }
}

/// Makes the next coordinates the granted ones.
void Guard::accept() {
  uint32_t first = 0;
  for (uint16_t i = 0; core_->roaming == 0 && i < robot_->pair_count; ++i) {
    GuardPair& known = pairs_[i];
    const Bounds now = bounds_of(i, first);
    const Keep keep = keep_of(i);
    if (!is_released(known.floor)) {
      // An earlier walk may have ended since the pair was tried, and left a worse certificate.
      const uint32_t by_begin = difference_of(known.granted, now.motion);
      known.granted = greater(greater(now.end, by_begin), keep.end);
      known.floor = smaller(greater(known.floor, known.granted), keep.cap);
    } else if (now.end >= known.granted) {
      known.granted = now.end;
      known.floor = smaller(now.end, keep.cap);
    }
    first += robot_->pairs[i].joints_a + robot_->pairs[i].joints_b;
  }
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    granted_[i] = next_[i];
    tried_[i] = kNoCoordinate;
  }
}

/// The longest way of a joint from the granted to the next coordinates.
uint32_t Guard::longest_way() const {
  uint32_t longest = 0;
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    longest = greater(longest, detail::magnitude(step_from(granted_[i], i)));
  }
  return longest;
}

/// The share at which the last command had too little work, if this one is the same; or the whole.
/// Sets the pair that allowed no more then.
uint32_t Guard::first_share(const JointCoordinate* wanted, JointCoordinate* granted,
                            LimitAnswer& answer) {
  const uint32_t share = core_->share;
  core_->share = 0;
  if (share == 0 || share >= kWhole || core_->shortened_by >= robot_->pair_count) {  // or damaged
    return kWhole;
  }
  set_share(wanted, share, granted);
  (void)set_coordinates(*robot_, granted, next_);
  if (is_tried()) {
    answer.pair = core_->shortened_by;
    return share;
  }
  (void)set_coordinates(*robot_, wanted, next_);
  return kWhole;
}

/// Tries smaller and smaller shares of the way, until all pairs keep what they have to. Sets the
/// pairs of the answer, and why the way was not granted whole.
uint32_t Guard::find_share(const JointCoordinate* wanted, JointCoordinate* granted, uint32_t& work,
                           LimitAnswer& answer) {
  uint32_t share = first_share(wanted, granted, answer);
  for (int tries = 1; share != 0; ++tries) {
    const Try tried = try_all(work);
    if (tried.status == Status::done) {
      accept();
      break;
    }
    if (tried.status == Status::suspended && core_->share == 0) {
      core_->share = static_cast<uint16_t>(share);
      core_->shortened_by = answer.pair;
      for (uint32_t i = 0; i < robot_->joint_count; ++i) {
        tried_[i] = next_[i];
      }
    }
    const bool is_first = answer.status == Status::done || tried.status != Status::full;
    answer.status = is_first ? tried.status : answer.status;
    answer.opposed = answer.pair != tried.pair ? answer.pair : answer.opposed;
    answer.pair = tried.pair;
    const uint32_t less = part_of(share, tried.up * kSafe, tried.down * 16);
    share = tries == kMostTries                   ? 0
            : tries > kManyTries || less == share ? smaller(less, share / kFaster)
                                                  : less;
    set_share(wanted, share, granted);
    (void)set_coordinates(*robot_, granted, next_);
    core_->has_frames = 0;
    share = longest_way() != 0 ? share : 0;
  }
  if (answer.pair != kNoPair) {
    answer.floor = floor(answer.pair);
    answer.distance = is_released(pairs_[answer.pair].floor) ? 0 : pairs_[answer.pair].granted;
  }
  return share;
}

LimitAnswer Guard::limit(const JointCoordinate* wanted, JointCoordinate* granted, uint32_t work) {
  const uint32_t budget = work;
  LimitAnswer answer = {begin_command(wanted), LimitVerdict::refused, 0, kNoPair, kNoPair, 0, 0, 0};
  if (answer.status != Status::done) {
    if (has_values()) {
      set_share(granted, 0, granted);
    }
    return answer;
  }
  for (uint32_t i = 0; i < robot_->joint_count; ++i) {
    if (robot_->joints[i].type == JointType::fixed && granted_[i] != next_[i]) {
      follow_obstacle(i);
    }
  }
  const uint32_t longest = longest_way();
  uint32_t share = kWhole;
  if (longest < core_->roaming) {
    const uint32_t roaming = core_->roaming - longest;
    accept();
    core_->roaming = roaming;
  } else {
    if (!knows_floors()) {
      answer.status = know_floors(work);
      (void)set_coordinates(*robot_, wanted, next_);
      core_->has_frames = 0;
    }
    share = answer.status == Status::done ? find_share(wanted, granted, work, answer) : 0;
  }
  if (share == kWhole || share == 0) {
    set_share(wanted, share, granted);
  }
  core_->has_frames = 0;
  answer.share = static_cast<uint16_t>(share);
  answer.verdict = share == kWhole                      ? LimitVerdict::granted
                   : answer.status == Status::suspended ? LimitVerdict::not_yet_known
                   : share == 0                         ? LimitVerdict::held
                                                        : LimitVerdict::shortened;
  const bool is_error = answer.status != Status::full && answer.status != Status::suspended;
  answer.status = is_error ? answer.status : Status::done;
  answer.work = budget - work;
  return answer;
}

}  // namespace flashbvh
