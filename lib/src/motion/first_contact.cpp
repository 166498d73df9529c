// First contact: chooses intervals of a motion and certifies each one.
#include "flashbvh/first_contact.hpp"

#include "fine_pair.hpp"
#include "moved_frame.hpp"
#include "near_query.hpp"

#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh {

namespace {

/// If bodies come near, an interval moves B by at most a quarter of a cell, and the search ends
/// after four such intervals. So the reported interval is at most a cell of motion.
constexpr uint32_t kShortestReach = kFineOne / 8;
constexpr uint8_t kMostNearSteps = 4;
/// A walk tests the begin only if no interval down to 1/kLateWalk of the motion is certified.
constexpr uint32_t kLateWalk = 4;

/// So a walk can test the distance of each interval that is too short to be cut.
static_assert(kMaxMotionDistance + 512 * kFineOne < detail::Within::kMostShort,
              "errors of paths and of rounding are below 512 cells");
/// Work of kinematics and a test of two triangles (query.hpp).
constexpr uint32_t kProbeWork = 64;
/// Work of kinematics, and of making and resuming a query.
constexpr uint32_t kSliceWork = 32;

/// Times are even, so that each interval has a middle.
constexpr uint32_t halved(uint32_t step) {
  return step > 4 ? (step / 2) & ~1u : 2;
}

}  // namespace

template <class MeshType>
BasicFirstContact<MeshType>::BasicFirstContact(const Mesh& a, const Mesh& b,
                                               const BodyMotion& motion, FineLength within)
    : a_(&a), b_(&b), motion_(&motion), within_(within.count), at_() {
  at_.near_since = Cursor::kNever;
  at_.step = kMotionEnd;
  at_.status = prepare();
  at_.outcome = ContactOutcome::close;
  at_.phase = ContactPhase::choose;
  if (at_.status != Status::suspended) {
    at_.phase = ContactPhase::done;
  }
}

/// Returns the error, or `suspended`.
template <class MeshType>
Status BasicFirstContact<MeshType>::prepare() {
  if (!detail::have_one_cell(*a_, *b_)) {
    return detail::cell_error(*a_, *b_);
  }
  if (motion_->status() != Status::done) {
    return motion_->status();
  }
  if (within_ > kMaxMotionDistance) {
    return Status::distance_out_of_range;
  }
  if (motion_->move_count() > kMostMoves ||
      !reach_.set(*motion_, b_->nodes[0].box, a_->origin, b_->origin)) {
    return Status::motion_out_of_range;
  }
  return Status::suspended;
}

/// Extra distance that an interval at an end of the motion must certify, in 1/256 cell. It covers
/// the pose there, as rounded to the lattice.
template <class MeshType>
uint32_t BasicFirstContact<MeshType>::margin_in(uint32_t step) const {
  const bool begins = at_.time == 0 && at_.is_begun == 0;
  const bool ends = at_.time + step == kMotionEnd && at_.walks_at_end == 0;
  return begins || ends ? reach_.rounding() : 0;
}

/// Distance that certifies an interval if the bodies are farther apart in its middle: B's motion
/// until either end, `within` and margins, in 1/256 cell. `frame`: B's in the middle.
template <class MeshType>
uint32_t BasicFirstContact<MeshType>::distance_in(uint32_t step, Frame& frame) const {
  const uint32_t half = step / 2;
  const uint64_t distance = reach_.around(*motion_, at_.time + half, half, frame) + within_ +
                            reach_.path_error() + margin_in(step);
  return distance < UINT32_MAX ? static_cast<uint32_t>(distance) : UINT32_MAX;
}

/// Returns whether the interval is too short to be halved.
template <class MeshType>
bool BasicFirstContact<MeshType>::is_shortest(uint32_t distance) const {
  const uint32_t added = within_ + reach_.path_error() + margin_in(at_.step);
  return at_.step == 2 || distance - added <= kShortestReach;
}

/// Returns whether two triangles are farther apart than a distance, with B at `frame`. Not inlined:
/// keeps this stack frame out of the walk's.
template <class MeshType>
FLASHBVH_NOINLINE bool BasicFirstContact<MeshType>::is_apart(const Witness<Index>& slots,
                                                             const Frame& frame,
                                                             uint32_t distance) const {
  detail::FinePair pair;
  detail::set_fine_pair(*a_, slots.a, *b_, slots.b, frame, distance, within_, pair);
  return detail::is_apart(pair, distance);
}

/// Direction between the hint's triangles; zero without a hint. Not inlined, as is_apart().
template <class MeshType>
FLASHBVH_NOINLINE detail::PackedVector BasicFirstContact<MeshType>::direction_at(
    const Frame& frame) const {
  if (at_.hint.is_none()) {
    return {0, 0};
  }
  detail::FinePair pair;
  detail::set_fine_pair(*a_, at_.hint.a, *b_, at_.hint.b, frame, detail::kCoarseDistance, 0, pair);
  return detail::direction_between(pair);
}

/// Returns whether the hint's triangles may touch in an interval; false without a hint.
template <class MeshType>
bool BasicFirstContact<MeshType>::may_touch(uint32_t step, uint32_t& distance) const {
  Frame frame;
  distance = distance_in(step, frame);
  if (at_.hint.is_none()) {
    return false;
  }
  detail::FinePair pair;
  detail::set_fine_pair(*a_, at_.hint.a, *b_, at_.hint.b, frame, distance, within_, pair);
  return distance < detail::kCoarseDistance ? !detail::is_apart(pair, distance)
                                            : detail::has_near_corners(pair, distance);
}

template <class MeshType>
void BasicFirstContact<MeshType>::choose() {
  uint32_t distance = 0;
  if (may_touch(at_.step, distance)) {
    come_near(distance);
  } else {
    at_.phase = at_.hint.is_none() ? ContactPhase::walk : ContactPhase::lengthen;
  }
}

template <class MeshType>
void BasicFirstContact<MeshType>::lengthen() {
  const uint32_t longer = (at_.step + at_.step / 2) & ~1u;
  uint32_t distance = 0;
  if (longer <= kMotionEnd - at_.time && !may_touch(longer, distance)) {
    at_.step = longer;
  }
  at_.phase = ContactPhase::walk;
}

/// The bodies may touch in the interval. Halves it; or, if it is too short, passes it and tests the
/// pose at its end.
template <class MeshType>
void BasicFirstContact<MeshType>::come_near(uint32_t distance) {
  at_.walk = {};
  const bool is_short = is_shortest(distance);
  if (at_.time == 0 && at_.is_begun == 0 && (is_short || at_.step <= kMotionEnd / kLateWalk)) {
    at_.phase = ContactPhase::at_time;
    return;
  }
  if (!is_short) {
    at_.step = halved(at_.step);
    at_.phase = ContactPhase::choose;
    return;
  }
  if (margin_in(at_.step) != 0) {
    at_.walks_at_end = 1;
    at_.phase = ContactPhase::choose;
    return;
  }
  if (at_.near_since == Cursor::kNever) {
    at_.near_since = at_.time;
    at_.near_steps = 0;
  }
  ++at_.near_steps;
  at_.time += at_.step;
  at_.phase = ContactPhase::at_time;
}

/// The bodies are apart in the whole interval. Proceeds to the next one.
template <class MeshType>
void BasicFirstContact<MeshType>::certify() {
  if (at_.near_since != Cursor::kNever) {
    end(ContactOutcome::close);
    return;
  }
  at_.is_begun = 1;
  at_.time += at_.step;
  at_.step = at_.step < kMotionEnd / 4 ? 4 * at_.step : kMotionEnd;
  if (at_.time == kMotionEnd && at_.walks_at_end == 0) {
    end(ContactOutcome::free);
  } else {
    go_on();
  }
}

/// Continues from `time`.
template <class MeshType>
void BasicFirstContact<MeshType>::go_on() {
  const uint32_t left = kMotionEnd - at_.time;
  at_.step = at_.step < left ? at_.step : left;
  at_.phase = left == 0 ? ContactPhase::at_time : ContactPhase::choose;
  at_.walk = {};
}

template <class MeshType>
void BasicFirstContact<MeshType>::end(ContactOutcome outcome) {
  at_.outcome = outcome;
  at_.status = Status::done;
  at_.phase = ContactPhase::done;
  at_.walk = {};
}

/// Runs a slice of a query from the walk's cursor. `take(query, slots)` returns whether the query
/// goes on after a pair.
template <class MeshType>
template <class Query, class Take>
Status BasicFirstContact<MeshType>::walk(Query&& query, uint32_t& work, const Take& take) {
  const Status status = query.resume(at_.walk);
  if (status != Status::suspended) {
    return status;
  }
  const RunResult slice = query.run(work, [&](const TrianglePair<Index>&) {
    const auto slots = query.template last_slots<Witness<Index>>();
    const bool goes_on = take(query, slots);
    at_.hint = goes_on ? at_.hint : slots;
    return goes_on;
  });
  detail::take_work(work, slice.work + kSliceWork);
  at_.walk = query.cursor();
  return slice.status;
}

template <class MeshType>
void BasicFirstContact<MeshType>::walk_at_time(uint32_t& work) {
  const Pose pose = motion_->pose_at(at_.time);
  const auto any = [](const auto&, const Witness<Index>&) { return false; };
  const Status status =
      within_ == 0
          ? walk(Query<Ranked<Mesh>>(*a_, *b_, pose), work, any)
          : walk(Query<Ranked<Mesh>, Within>(*a_, *b_, pose, {}, flashbvh::within({within_})), work,
                 any);
  if (status == Status::full) {
    end(ContactOutcome::contact);
  } else if (status != Status::done) {
    at_.status = status;
  } else if (at_.near_since != Cursor::kNever &&
             (at_.near_steps == kMostNearSteps || at_.time == kMotionEnd)) {
    end(ContactOutcome::close);
  } else if (at_.time == kMotionEnd) {
    end(ContactOutcome::free);
  } else {
    at_.is_begun = 1;
    go_on();
  }
}

template <class MeshType>
void BasicFirstContact<MeshType>::walk_interval(uint32_t& work) {
  Frame frame;
  const uint32_t distance = distance_in(at_.step, frame);
  if (distance >= detail::Within::kMostShort - reach_.rounding()) {
    come_near(distance);
    return;
  }
  const Pose pose = detail::pose_of(frame);
  const Status status = walk(
      detail::NearQuery<Mesh>(*a_, *b_, pose, distance + reach_.rounding(), direction_at(frame)),
      work, [&](const auto& query, const Witness<Index>& slots) {
        return is_apart(slots, frame, distance) || !query.is_pair_within();
      });
  if (status == Status::done) {
    certify();
  } else if (status == Status::full || status == Status::distance_out_of_range) {
    come_near(distance);  // also if the bodies are too far apart for a query with this distance
  } else {
    at_.status = status;
  }
}

template <class MeshType>
void BasicFirstContact<MeshType>::step(uint32_t& work) {
  if (at_.phase == ContactPhase::at_time) {
    walk_at_time(work);
  } else if (at_.phase == ContactPhase::walk) {
    walk_interval(work);
  } else {
    detail::take_work(work, kProbeWork);
    at_.phase == ContactPhase::choose ? choose() : lengthen();
  }
}

/// Terminates with unlimited work: each step continues a walk, halves an interval that is not the
/// shortest, or passes one.
template <class MeshType>
typename BasicFirstContact<MeshType>::Answer BasicFirstContact<MeshType>::run(uint32_t work) {
  while (at_.status == Status::suspended && work != 0) {
    step(work);
  }
  Answer answer = {status(), at_.outcome, {}, at_.time, at_.time};
  if (at_.near_since != Cursor::kNever) {
    answer.from = at_.near_since;
  }
  if (at_.status == Status::done && !at_.hint.is_none() && at_.outcome != ContactOutcome::free) {
    answer.triangles = {a_->triangle_ids[at_.hint.a], b_->triangle_ids[at_.hint.b]};
  }
  return answer;
}

template <class MeshType>
void BasicFirstContact<MeshType>::pass() {
  if (at_.status != Status::done || at_.outcome != ContactOutcome::close) {
    return;
  }
  at_.near_since = Cursor::kNever;
  if (at_.time == kMotionEnd) {
    end(ContactOutcome::free);
    return;
  }
  at_.status = Status::suspended;
  go_on();
}

template <class MeshType>
Status BasicFirstContact<MeshType>::resume(const Cursor& at) {
  if (status() != Status::suspended) {
    return status();
  }
  // After an interval that came near, `step` still holds its length.
  const bool is_behind = at.phase == ContactPhase::at_time;
  const uint32_t longest = is_behind ? kMotionEnd : kMotionEnd - at.time;
  const bool is_even = ((at.time | at.step) & 1) == 0;
  const bool is_in_motion = at.time <= kMotionEnd && at.step <= longest;
  const bool has_step = at.step != 0 || (is_behind && at.time == kMotionEnd);
  const bool has_pair = at.hint.is_none() || detail::is_pair(at.hint, *a_, *b_);
  const bool is_known = (at.near_since == Cursor::kNever || at.near_since <= at.time) &&
                        at.phase < ContactPhase::done && at.status == Status::suspended;
  if (!(is_even && is_in_motion && has_step && has_pair && is_known)) {
    return Status::cursor_invalid;
  }
  at_ = at;
  return Status::suspended;
}

template class BasicFirstContact<Mesh>;
template class BasicFirstContact<Mesh32>;

}  // namespace flashbvh
